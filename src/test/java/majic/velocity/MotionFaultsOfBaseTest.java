package majic.velocity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicBoolean;
import majic.bot.BotListener;
import majic.bot.Guard;
import majic.bot.LinkLost;
import majic.bot.MajicBot;
import majic.bot.MotionFailed;
import majic.bot.MotionReport;
import majic.bot.Pose;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** What ends a motion from the robot's side: contacts, a lack of progress, odometry that fails, a lost connection. */
class MotionFaultsOfBaseTest {
    @AutoClose
    private final ModelRobot robot = new ModelRobot(BaseModel.Traits.USUAL);

    private final ModelDriver bot = robot.bot();
    private final List<String> notices = Collections.synchronizedList(new ArrayList<>());

    private CompletableFuture<MotionReport> movedTo(double mm) {
        bot.addListener(new Notices());
        bot.connect();
        CompletableFuture<MotionReport> motion = robot.clock.aside(() -> bot.move(1000));
        robot.clock.until(() -> robot.truePose().xMm() > mm);
        return motion;
    }

    private void assertFails(CompletableFuture<MotionReport> motion, String reason) {
        assertThatThrownBy(() -> robot.clock.join(motion))
                .hasCauseInstanceOf(MotionFailed.class)
                .hasMessageMatching(".*: " + reason + " after (19|2[0-2])\\d mm");
        pass(1);
        assertThat(robot.base.mmPerSec()).isZero();
        assertThat(robot.base.received()).endsWith(zeros(robot.base.received(), 3));
    }

    /** The last commands, if they are zeros. */
    private static BaseModel.Command[] zeros(List<BaseModel.Command> all, int number) {
        return all.subList(all.size() - number, all.size()).stream()
                .map(sent -> new BaseModel.Command(0, 0, sent.atMs()))
                .toArray(BaseModel.Command[]::new);
    }

    @Test
    void aBlockedBaseIsStoppedAfterTwoSecondsWithTheDistanceCovered() {
        CompletableFuture<MotionReport> motion = movedTo(200);
        robot.block();
        double sinceS = seconds();

        assertFails(motion, "blocked: no progress for 2 s");

        assertThat(seconds() - sinceS).isBetween(2.0, 3.5);
    }

    @Test
    void aBaseThatIsBlockedJustBeforeItsTargetHasArrived() {
        CompletableFuture<MotionReport> motion = movedTo(992);
        robot.block();

        assertThat(robot.clock.join(motion).amount().number()).isCloseTo(993, within(2.0));
    }

    @Test
    void aReflexOfTheBaseIsReportedAsSuch() {
        CompletableFuture<MotionReport> motion = movedTo(200);
        bot.obstruction = new Obstruction("bump at the front left", Obstruction.Side.FRONT, true, now());

        assertFails(motion, "its own reflex stopped it: bump at the front left");
    }

    @Test
    void aPressedFrontBumperPreventsMotionsAheadOnly() {
        bot.connect();
        bot.every(
                "bumper",
                0.02,
                () -> bot.obstruction = new Obstruction("front bumper pressed", Obstruction.Side.FRONT, false, now()));
        pass(0.1);

        assertThatThrownBy(() -> bot.move(100))
                .isInstanceOf(MotionFailed.class)
                .hasMessage("front bumper pressed after 0 mm");
        assertThat(bot.turn(30).amount().number()).isCloseTo(30, within(1.0));
        assertThat(bot.move(-100).amount().number()).isCloseTo(-100, within(5.0));
    }

    @Test
    void anOldContactDoesNotPreventAMotion() {
        bot.connect();
        bot.obstruction = new Obstruction("bump", Obstruction.Side.ALL, true, now());
        pass(0.4);

        assertThat(bot.move(50).amount().number()).isCloseTo(50, within(5.0));
    }

    @Test
    void aMotionEndsWhenTheOdometryIsSilentForASecond() {
        CompletableFuture<MotionReport> motion = movedTo(200);
        robot.base.silent = true;
        double sinceS = seconds();

        assertFails(motion, "its odometry has been silent for 1 s");

        assertThat(seconds() - sinceS).isBetween(1.0, 2.3);
    }

    @Test
    void aMotionEndsWhenTheOdometryArrivesMuchTooLate() {
        CompletableFuture<MotionReport> motion = movedTo(200);
        bot.lateS = 6.5;

        assertFails(motion, "its odometry arrives 6.5 s late");
        assertThat(bot.get("age").number()).isGreaterThanOrEqualTo(6500);
    }

    @Test
    void aBaseWithSilentOdometryIsNotMoved() {
        CompletableFuture<MotionReport> motion = movedTo(200);
        robot.base.silent = true;
        assertFails(motion, "its odometry has been silent for 1 s");
        int before = robot.base.received().size();
        double sinceS = seconds();

        assertThatThrownBy(() -> bot.move(100)).hasMessage("its odometry has been silent for 1 s after 0 mm");
        assertThatThrownBy(() -> bot.turn(90)).hasMessage("its odometry has been silent for 1 s after 0 deg");
        assertThatThrownBy(() -> bot.drive(100, 0)).hasMessage("its odometry has been silent for 1 s");

        assertThat(seconds() - sinceS).isLessThan(0.2);
        assertThat(robot.base.received().subList(before, robot.base.received().size()))
                .allMatch(BaseModel.Command::isZero);
    }

    @Test
    void aMotionEndsWhenTheOdometryHasNoUsablePoseForASecond() {
        CompletableFuture<MotionReport> motion = movedTo(200);
        robot.base.silent = true;
        bot.every("unusable odometry", 0.05, () -> bot.motions.unusable("pose.pose.position.x is null"));

        assertFails(motion, "its odometry is unusable: pose.pose.position.x is null");
    }

    @Test
    void aMotionEndsWhenTheOdometryIsSetToZeroAndThePositionGoesOn() {
        CompletableFuture<MotionReport> motion = movedTo(200);
        Pose before = robot.truePose();
        robot.base.frame = Pose.START.originOf(before);

        assertFails(motion, "its odometry jumped");

        assertThat(bot.state().pose().distanceMm(robot.truePose())).isLessThan(20);
        assertThat(notices).anyMatch(text -> text.contains("jumped or was reset"));
    }

    @Test
    void aMotionEndsWhenTheOdometryJumps() {
        CompletableFuture<MotionReport> motion = movedTo(200);
        robot.base.frame = new Pose(9000, 0, 20);

        assertFails(motion, "its odometry jumped");

        assertThat(bot.state().pose().distanceMm(robot.truePose())).isLessThan(20);
        assertThat(bot.move(100).amount().number()).isCloseTo(100, within(5.0));
    }

    @Test
    void aDriveThatIsBlockedEndsAndTheNextCallHasTheReason() {
        bot.connect();
        robot.block();
        Throwable reason = null;
        for (int call = 0; call < 20 && reason == null; call++) {
            try {
                bot.drive(150, 0);
                pass(0.2);
            } catch (MotionFailed e) {
                reason = e;
            }
        }

        assertThat(reason).isInstanceOf(MotionFailed.class).hasMessage("blocked: no progress for 2 s");
        pass(0.3);
        assertThat(robot.base.received()).endsWith(zeros(robot.base.received(), 3));
    }

    @Test
    void aDriveThatTheRobotEndedIsReportedByANoticeWhenItIsNotRenewed() {
        bot.addListener(new Notices());
        bot.connect();
        bot.drive(150, 0);
        pass(0.4);
        bot.obstruction = new Obstruction("cliff at the front", Obstruction.Side.ALL, true, now());

        pass(2);

        assertThat(notices).contains("the drive ended: its own reflex stopped it: cliff at the front");
    }

    /** The threads of the driver do not run for 5 s; the odometry that has come meanwhile is there at once. */
    private Guard heldUpAt(double mm) {
        AtomicBoolean done = new AtomicBoolean();
        return () -> {
            if (robot.truePose().xMm() > mm && done.compareAndSet(false, true)) {
                pass(5);
            }
            return false;
        };
    }

    @Test
    void aMotionWhoseThreadWasHeldUpEndsAndDoesNotGoOn() {
        bot.connect();
        CompletableFuture<MotionReport> motion = robot.clock.aside(() -> bot.move(1000, heldUpAt(200)));
        robot.clock.until(() -> robot.truePose().xMm() > 200);
        pass(4);
        double stoppedMm = robot.truePose().xMm();
        int before = robot.base.received().size();

        assertThatThrownBy(() -> robot.clock.join(motion))
                .hasCauseInstanceOf(MotionFailed.class)
                .hasMessageContaining("this program stood still for 5 s after 2");

        pass(2);
        assertThat(robot.truePose().xMm()).isEqualTo(stoppedMm);
        assertThat(robot.base.received().subList(before, robot.base.received().size()))
                .isNotEmpty()
                .allMatch(BaseModel.Command::isZero);
    }

    @Test
    void aMotionOfAProgramThatWasHeldUpEndsWhicheverThreadGoesOnFirst() {
        bot.connect();
        CompletableFuture<MotionReport> motion = robot.clock.aside(() -> bot.move(1000, heldUpAt(200)));
        robot.clock.until(() -> robot.truePose().xMm() > 199);
        bot.every("held up", 0.001, holdUpOnce());
        pass(4.5);
        double stoppedMm = robot.truePose().xMm();
        int before = robot.base.received().size();

        assertThatThrownBy(() -> robot.clock.join(motion))
                .hasCauseInstanceOf(MotionFailed.class)
                .hasMessageContaining("this program stood still for 5 s");

        pass(2);
        assertThat(robot.truePose().xMm()).isEqualTo(stoppedMm);
        assertThat(robot.base.received().subList(before, robot.base.received().size()))
                .isNotEmpty()
                .allMatch(BaseModel.Command::isZero);
    }

    private Runnable holdUpOnce() {
        AtomicBoolean done = new AtomicBoolean();
        return () -> {
            if (done.compareAndSet(false, true)) {
                pass(5);
            }
        };
    }

    @Test
    void aDriveWhoseRepetitionWasHeldUpEndsAndTheNextCallHasTheReason() {
        bot.connect();
        for (int call = 0; call < 4; call++) {
            bot.drive(150, 0);
            pass(0.2);
        }
        bot.every("held up", 0.001, holdUpOnce());
        pass(4.9);
        double stoppedMm = robot.truePose().xMm();
        int before = robot.base.received().size();

        assertThatThrownBy(() -> bot.drive(150, 0))
                .isInstanceOf(MotionFailed.class)
                .hasMessage("this program stood still for 5 s");
        pass(2);

        assertThat(robot.truePose().xMm()).isEqualTo(stoppedMm);
        assertThat(robot.base.received().subList(before, robot.base.received().size()))
                .isNotEmpty()
                .allMatch(BaseModel.Command::isZero);
        bot.drive(150, 0);
        pass(0.3);
        assertThat(robot.truePose().xMm()).isGreaterThan(stoppedMm);
    }

    @Test
    void theLossOfAMovingBaseSaysWhenItStopsByItself() {
        CompletableFuture<MotionReport> motion = movedTo(200);

        robot.cut();

        assertThatThrownBy(() -> robot.clock.join(motion))
                .hasCauseInstanceOf(LinkLost.class)
                .hasMessageContaining("the robot stops by itself 0.5 s after the last command");
    }

    @Test
    void theLossOfABaseThatDrivesOnWarnsAndTheNextConnectionStopsItFirst() {
        try (ModelRobot endless = new ModelRobot(BaseModel.Traits.USUAL.drivingOn()).connected()) {
            CompletableFuture<MotionReport> motion = endless.clock.aside(() -> endless.bot.move(5000));
            endless.clock.until(() -> endless.truePose().xMm() > 200);
            endless.cut();
            assertThatThrownBy(() -> endless.clock.join(motion))
                    .hasMessageContaining("the robot may still be moving, since it keeps its last velocity");
            endless.clock.until(() -> endless.truePose().xMm() > 600);
            int before = endless.base.received().size();

            endless.connected();
            endless.clock.until(() -> endless.base.mmPerSec() == 0);

            assertThat(endless.base
                            .received()
                            .subList(before, endless.base.received().size()))
                    .isNotEmpty()
                    .allMatch(BaseModel.Command::isZero);
            endless.clock.until(() -> !endless.bot.state().moving());
            assertThat(endless.bot.state().pose().distanceMm(endless.truePose()))
                    .as("the odometry has not begun anew")
                    .isLessThan(1);
        }
    }

    private long now() {
        return bot.time().nanos();
    }

    private double seconds() {
        return bot.time().nanos() / 1e9;
    }

    private void pass(double seconds) {
        try {
            bot.time().sleep(seconds);
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    /** Keeps the notices. */
    private final class Notices implements BotListener {
        @Override
        public void notice(MajicBot from, String message) {
            notices.add(message);
        }
    }
}
