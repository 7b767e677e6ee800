package majic.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.atomic.AtomicBoolean;
import majic.bot.BotException;
import majic.bot.Course;
import majic.bot.Guard;
import majic.bot.MotionFailed;
import majic.bot.MotionReport;
import majic.bot.Pose;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Motions of a rover: velocities in GUIDED, what refuses and what ends them. */
class RoverMotionTest {
    @AutoClose
    private final DrivenRover robot = new DrivenRover();

    private final ScriptedRover rover = robot.rover;
    private final MajicMavlink bot = robot.bot();

    private void ready() {
        robot.ready();
    }

    private CompletableFuture<MotionReport> moving(double mm) {
        CompletableFuture<MotionReport> motion = robot.clock().aside(() -> bot.move(mm));
        robot.clock().until(() -> rover.mmPerSec() > 300 || motion.isDone());
        return motion;
    }

    private Throwable failure(CompletableFuture<MotionReport> motion) {
        try {
            robot.clock().join(motion);
        } catch (CompletionException e) {
            return e.getCause();
        }
        throw new AssertionError("the motion did not fail");
    }

    @Test
    void aMoveSetsGuidedAndEndsWithZeroTargetsWhereItShould() {
        ready();

        MotionReport report = bot.move(3000);
        robot.pass(1);

        assertThat(report.amount()).isNotNull();
        assertThat(rover.pose.xMm()).isCloseTo(3000, within(100.0));
        assertThat(rover.mode).isEqualTo(ScriptedRover.GUIDED);
        assertThat(rover.mmPerSec()).isZero();
        List<VehicleFrames.Got> targets = rover.targets();
        assertThat(targets).allMatch(got -> got.u8(52) == 8 && (got.u16(48) == 0x05E7 || got.u16(48) == 0x05FF));
        VehicleFrames.Got last = targets.get(targets.size() - 1);
        assertThat(last.f32(16)).isZero();
        assertThat(last.f32(44)).isZero();
    }

    @Test
    void aTurnToTheLeftIsSentAsANegativeYawRateOnTheSpot() {
        ready();

        bot.turn(90);

        assertThat(rover.pose.headingDeg()).isCloseTo(90, within(2.0));
        assertThat(rover.targets())
                .filteredOn(got -> got.f32(44) != 0)
                .isNotEmpty()
                .allMatch(got -> got.u16(48) == 0x05FF && got.f32(16) == 0);
        assertThat(rover.targets().get(0).f32(44)).isNegative();
    }

    @Test
    void targetsAreSentTenTimesASecondWhileItMoves() {
        ready();
        CompletableFuture<MotionReport> motion = moving(5000);
        int before = rover.targets().size();
        robot.pass(2);

        assertThat(rover.targets().size() - before).isBetween(18, 22);
        robot.clock().join(motion);
    }

    @Test
    void anUnarmedRoverRefusesToMoveAndNamesTheReasonsOfItsAutopilot() {
        bot.connect();
        rover.text("PreArm: AHRS: waiting for home");
        robot.pass(0.1);

        assertThatThrownBy(() -> bot.move(1000))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("it is not armed")
                .hasMessageContaining("PreArm: AHRS: waiting for home");
        assertThat(rover.commands(400)).isEmpty();
        assertThat(rover.mode).isZero();
    }

    @Test
    void armArmsOrNamesTheReasons() {
        bot.connect();
        rover.armRefusal = "Arm: Accels inconsistent";

        assertThatThrownBy(() -> bot.run("arm", List.of()))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("refuses to arm (failed): Arm: Accels inconsistent");

        rover.armRefusal = "";
        bot.run("arm", List.of());
        assertThat(rover.armed).isTrue();
        bot.run("disarm", List.of());
        assertThat(rover.armed).isFalse();
        assertThat(rover.commands(400)).allMatch(got -> got.f32(4) == 0);
    }

    @Test
    void aCommandThatIsInProgressIsAwaitedAndNotSentAgain() {
        bot.connect();
        rover.armingMs = 9000;

        bot.run("arm", List.of());

        assertThat(rover.armed).isTrue();
        assertThat(rover.commands(400)).hasSize(1);
    }

    @Test
    void aCommandThatIsInProgressForEverIsNotDone() {
        bot.connect();
        rover.armingMs = 1_000_000;
        long fromMs = robot.peer.millis();

        assertThatThrownBy(() -> bot.run("arm", List.of()))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("the autopilot does not finish the command to arm");

        assertThat(rover.commands(400)).hasSize(1);
        assertThat(robot.peer.millis() - fromMs).isBetween(29_000L, 33_500L);
    }

    @Test
    void aCommandWhoseFinalAnswerIsLostIsNotDone() {
        bot.connect();
        rover.armingMs = 1500;
        CompletableFuture<String> arming = robot.clock().aside(() -> bot.run("arm", List.of()));
        robot.clock().until(() -> !rover.commands(400).isEmpty());
        rover.answeredSystem = 245;

        assertThatThrownBy(() -> robot.clock().join(arming))
                .hasMessageContaining("the autopilot does not finish the command to arm");
        assertThat(rover.commands(400)).hasSize(1);
    }

    @Test
    void armByMotionLetsTheFirstMotionArm() {
        bot.connect();
        bot.set("armByMotion", "on");

        bot.move(1000);

        assertThat(rover.pose.xMm()).isCloseTo(1000, within(100.0));
        assertThat(rover.armed).isTrue();
    }

    @Test
    void aModeThatIsRefusedEndsTheMotionWithTheReason() {
        ready();
        rover.modeRefusal = "Flight mode change failed";

        assertThatThrownBy(() -> bot.move(1000))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("does not take on the mode GUIDED (failed): Flight mode change failed");
    }

    @Test
    void aModeThatAnotherHasSetEndsTheMotionAndIsNotTakenBack() {
        ready();
        CompletableFuture<MotionReport> motion = moving(5000);
        robot.pass(1.5);
        int modes = rover.commands(176).size();

        rover.changeMode(0);

        assertThat(failure(motion))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("the mode was changed to MANUAL by another");
        robot.pass(3);
        assertThat(rover.mode).isZero();
        assertThat(rover.commands(176)).hasSize(modes);
    }

    /** Drives for 1.5 s, stands for 3 s, in which another takes the vehicle over, and goes on by a step. */
    private Course standing(Course.Step goesOn) {
        long beganMs = robot.peer.millis();
        AtomicBoolean taken = new AtomicBoolean();
        return () -> {
            long passedMs = robot.peer.millis() - beganMs;
            if (passedMs > 3000 && taken.compareAndSet(false, true)) {
                rover.changeMode(0);
            }
            return passedMs < 1500
                    ? new Course.Drive(500, 0)
                    : passedMs < 4500 ? Course.Drive.STAND : passedMs < 8000 ? goesOn : new Course.Arrived(null);
        };
    }

    @Test
    void aCourseWhoseModeWasTakenOverWhileItStoodDoesNotTakeItBack() {
        ready();
        for (Course.Step goesOn : List.of(new Course.Drive(500, 0), new Course.Turn(90), new Course.Move(500))) {
            Course course = standing(goesOn);
            int before = rover.commands(176).size();
            CompletableFuture<MotionReport> motion = robot.clock().aside(() -> bot.follow(course, Guard.NEVER));

            assertThat(failure(motion))
                    .as("%s", goesOn)
                    .hasMessageContaining("the mode was changed to MANUAL by another");
            robot.pass(2);
            assertThat(rover.mode).isZero();
            assertThat(rover.commands(176)).hasSize(before + 1);
        }
    }

    @Test
    void aMotionThatIsCommandedAfterATakeoverSetsTheModeAgain() {
        ready();
        CompletableFuture<MotionReport> motion = moving(5000);
        rover.changeMode(0);
        failure(motion);

        bot.move(500);

        assertThat(rover.mode).isEqualTo(ScriptedRover.GUIDED);
    }

    @Test
    void aDriveWhoseModeWasTakenOverIsNotBegunAgainByItsRenewals() {
        ready();
        for (int call = 0; call < 15; call++) {
            bot.drive(500, 0);
            robot.pass(0.1);
        }
        rover.changeMode(0);
        int refused = 0;
        for (int call = 0; call < 20; call++) {
            try {
                bot.drive(500, 0);
            } catch (BotException e) {
                refused++;
            }
            robot.pass(0.1);
        }

        assertThat(refused).isGreaterThanOrEqualTo(19);
        assertThat(rover.mode).isZero();
    }

    @Test
    void aMotionThatWasHeldUpForLongerThanItsTargetsLastDoesNotGoOn() {
        ready();
        AtomicBoolean held = new AtomicBoolean();
        Guard stuck = () -> {
            if (rover.pose.xMm() > 1000 && held.compareAndSet(false, true)) {
                robot.pass(5);
            }
            return false;
        };
        CompletableFuture<MotionReport> motion = robot.clock().aside(() -> bot.move(5000, stuck));
        robot.clock().until(() -> rover.pose.xMm() > 1000);
        robot.pass(4.5);
        double stoppedMm = rover.pose.xMm();
        int before = rover.targets().size();

        assertThat(failure(motion))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("this program stood still for 5 s after");
        robot.pass(2);

        assertThat(rover.targets().subList(before, rover.targets().size()))
                .isNotEmpty()
                .allMatch(got -> got.f32(16) == 0 && got.f32(44) == 0);
        assertThat(rover.pose.xMm()).isCloseTo(stoppedMm, within(1.0));
    }

    @Test
    void aPositionWithoutAnAttitudeOfItsMomentIsNoPose() {
        ready();
        robot.pass(1);
        double before = bot.get("age").number();

        rover.withoutAttitude = true;
        robot.pass(0.45);

        assertThat(before).isLessThan(110);
        assertThat(bot.get("age").number()).isGreaterThan(200);
        CompletableFuture<MotionReport> motion = robot.clock().aside(() -> bot.move(1000));
        assertThat(failure(motion))
                .hasMessageMatching(
                        ".*its odometry is unusable: attitude and position are of moments [\\d.]+ s apart after \\d+ mm");
        assertThat(rover.pose.xMm()).isLessThan(300);
    }

    @Test
    void aPositionThatComesLaterThanItsAttitudeIsOfTheSameMoment() {
        ready();
        robot.pass(1);
        rover.positionLagMs = 190;
        robot.pass(0.5);

        assertThat(bot.get("age").number()).isLessThan(310);
        bot.turn(90);

        assertThat(rover.pose.headingDeg()).isCloseTo(90, within(2.0));
    }

    @Test
    void aRoverThatIsDisarmedEndsItsMotion() {
        ready();
        CompletableFuture<MotionReport> motion = moving(5000);
        robot.pass(1.5);

        rover.armed = false;

        assertThat(failure(motion)).isInstanceOf(MotionFailed.class).hasMessageContaining("it was disarmed");
    }

    @Test
    void aPositionThatIsLostEndsTheMotionWithinASecond() {
        ready();
        CompletableFuture<MotionReport> motion = moving(5000);
        long lostMs = robot.peer.millis();

        rover.positionless = true;

        assertThat(failure(motion)).isInstanceOf(MotionFailed.class);
        assertThat(robot.peer.millis() - lostMs).isLessThan(2500);
        robot.pass(2);
        assertThat(rover.mmPerSec()).isZero();
    }

    @Test
    void aRoverWithoutAPositionIsNotMoved() {
        rover.positionless = true;
        ready();

        assertThatThrownBy(() -> bot.move(1000)).isInstanceOf(MotionFailed.class);
        assertThat(rover.pose).isEqualTo(Pose.START);
    }

    @Test
    void theDriveEndsWhenItIsNotRenewed() {
        ready();

        bot.drive(500, 0);
        robot.pass(3);

        assertThat(rover.mmPerSec()).isZero();
        assertThat(rover.pose.xMm()).isBetween(50.0, 800.0);
    }

    @Test
    void gotoGlobalLeavesTheWayToTheAutopilot() {
        rover.frame = Pose.START;
        ready();
        robot.pass(1);

        String answer = bot.run("gotoGlobal", List.of(Value.of(47.0001, Unit.NONE), Value.of(9, Unit.NONE)));

        assertThat(answer).startsWith("arrived");
        assertThat(rover.pose.xMm()).isCloseTo(11_119, within(2500.0));
        VehicleFrames.Got sent = rover.received.stream()
                .filter(got -> got.id() == 75)
                .findFirst()
                .orElseThrow();
        assertThat(sent.i32(16)).isEqualTo(470_001_000);
        assertThat(sent.f32(4)).isEqualTo(1);
    }

    @Test
    void nothingMovesAPlane() {
        rover.type = 1;
        ready();

        assertThatThrownBy(() -> bot.move(1000)).hasMessageContaining("it is a plane");
        assertThatThrownBy(() -> bot.turn(10)).hasMessageContaining("it is a plane");
        assertThatThrownBy(() -> bot.drive(500, 0)).hasMessageContaining("it is a plane");
        assertThatThrownBy(() -> bot.run("arm", List.of())).isInstanceOf(BotException.class);
        assertThatThrownBy(() -> bot.set("mode", "AUTO")).hasMessageContaining("does not set AUTO");
        assertThat(rover.targets()).isEmpty();
        assertThat(rover.commands(176)).isEmpty();
        assertThat(rover.commands(400)).isEmpty();
    }

    @Test
    void anAircraftIsTakenDownAndHome() {
        rover.type = 2;
        ready();

        bot.run("land", List.of());
        assertThat(rover.mode).isEqualTo(9);
        bot.run("home", List.of());
        assertThat(rover.mode).isEqualTo(6);
        bot.run("hold", List.of());
        assertThat(rover.mode).isEqualTo(17);
    }

    @Test
    void aModeIsNotSetAndNotSaidToBeWhenTheConditionHoldsAlready() {
        rover.type = 2;
        ready();

        assertThat(bot.run("land", List.of(), () -> true)).isEqualTo("not in LAND: the condition holds already");

        assertThat(rover.commands(176)).isEmpty();
        assertThat(rover.mode).isZero();
    }

    @Test
    void theModeOfTheStopIsSetThoughTheConditionHoldsAlready() {
        ready();

        bot.run("hold", List.of(), () -> true);

        assertThat(rover.mode).isEqualTo(ScriptedRover.HOLD);
    }

    @Test
    void aModeIsNotSaidToBeSetWhenTheConditionBecomesTrueBeforeItIsShown() {
        rover.type = 2;
        ready();
        rover.ignoresModes = true;
        long fromMs = robot.peer.millis();

        assertThat(bot.run("home", List.of(), () -> robot.peer.millis() > fromMs + 400))
                .isEqualTo("not confirmed to be in RTL: the condition became true before");
    }

    @Test
    void aRoverIsNotSaidToBeUnarmedWhenTheConditionBecomesTrueAfterTheCommand() {
        bot.connect();
        rover.armingMs = 2000;
        long fromMs = robot.peer.millis();

        assertThat(bot.run("arm", List.of(), () -> true)).isEqualTo("not armed: the condition holds already");
        assertThat(rover.commands(400)).isEmpty();
        assertThat(bot.run("arm", List.of(), () -> robot.peer.millis() > fromMs + 700))
                .isEqualTo("not confirmed to be armed: the condition became true before");
    }

    @Test
    void anAnswerToAnotherGroundStationIsNone() {
        robot.ready();
        rover.answeredSystem = 245;

        assertThatThrownBy(() -> bot.run("arm", List.of()))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("does not answer the command to arm");
    }

    @Test
    void whatTheHeartbeatsDoNotShowIsNotDone() {
        robot.ready();
        rover.onlyAnswers = true;

        assertThatThrownBy(() -> bot.run("disarm", List.of()))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("its heartbeats do not show it");
        assertThatThrownBy(() -> bot.run("hold", List.of()))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("the autopilot accepts HOLD, but its heartbeats show MANUAL");
    }

    @Test
    void positionsThatComeLaterAndLaterEndAMotion() {
        robot.ready();
        robot.pass(1);
        rover.congested = true;

        assertThatThrownBy(() -> bot.move(5000))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("its odometry arrives")
                .hasMessageContaining("s late");
    }

    @Test
    void theEndOfTheTargetIsANoticeOnlyInAMotion() {
        robot.ready();
        bot.move(300);
        rover.text("target not received last 3secs, stopping");
        robot.pass(0.1);
        assertThat(robot.notices()).noneMatch(notice -> notice.contains("target not received"));

        CompletableFuture<?> moving = robot.clock().aside(() -> bot.move(3000));
        robot.clock().until(() -> rover.mmPerSec() > 300 || moving.isDone());
        rover.text("target not received last 4secs, stopping");
        robot.clock().join(moving);
        assertThat(robot.notices()).anyMatch(notice -> notice.contains("target not received"));
    }
}
