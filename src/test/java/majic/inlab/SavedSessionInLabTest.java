package majic.inlab;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import majic.bot.Pose;
import majic.team.ManualControl;
import majic.team.Member;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that running a saved session again moves a simulated robot to the same place. */
class SavedSessionInLabTest {
    /**
     * The largest distance between the ends of a replay and of the session; the robot moves this far in a twentieth of
     * a second.
     */
    private static final double NEAR_MM = 12;

    /** The shortfall of a manual drive, since the robot brakes at the change from straight ahead to a curve. */
    private static final double BRAKED_MM = 60;

    @TempDir
    private Path folder;

    private static Pose replayed(String type, Path saved) throws InterruptedException {
        try (LabRig again = LabRig.exact()) {
            assertThat(again.run("run \"" + saved + "\"")).noneMatch(line -> line.contains("failed"));
            return again.truePose(type);
        }
    }

    /** Drives at 200 mm/s, renewing the speeds every 0.15 s. */
    private static void drive(LabRig lab, ManualControl hand, double degPerSec, int times) throws InterruptedException {
        for (int time = 0; time < times; time++) {
            hand.drive(200, degPerSec);
            lab.lab().time().sleep(0.15);
        }
    }

    private static double apart(Pose one, Pose other) {
        return Math.hypot(one.xMm() - other.xMm(), one.yMm() - other.yMm());
    }

    @ParameterizedTest
    @ValueSource(strings = {"pioneer", "hemisson", "aibo"})
    void aMoveThatWasCutIsCutAgain(String type) throws InterruptedException {
        Path saved = folder.resolve("cut.majic");
        try (LabRig lab = LabRig.exact()) {
            lab.run("add sim:" + type);
            Pose start = lab.truePose(type);
            lab.say("1 move 480");
            lab.await(() -> apart(start, lab.truePose(type)) > 100);
            lab.team().stopAll();
            lab.await(lab.team().member(1)::isIdle);
            Pose end = lab.truePose(type);
            lab.run("save session \"" + saved + "\"");
            assertThat(apart(start, end)).isBetween(100.0, 300.0);
            assertThat(apart(replayed(type, saved), end)).isLessThan(NEAR_MM);
        }
    }

    /** Sends a stop in one of the ways that there are. */
    private enum Stop {
        BUTTON_OR_KEY {
            @Override
            void send(LabRig lab) {
                lab.team().stopAll();
            }
        },
        TAB {
            @Override
            void send(LabRig lab) {
                lab.team().stop(lab.team().members(), null);
            }
        },
        LINE {
            @Override
            void send(LabRig lab) {
                lab.say("1 stop");
            }
        },
        LINE_FOR_ALL {
            @Override
            void send(LabRig lab) {
                lab.say("stop");
            }
        };

        abstract void send(LabRig lab);
    }

    @ParameterizedTest
    @EnumSource(Stop.class)
    void aMoveThatWasCutByAnyStopGoesNoFurtherAgain(Stop stop) throws InterruptedException {
        Path saved = folder.resolve("cut.majic");
        try (LabRig lab = LabRig.exact()) {
            lab.run("add sim:pioneer");
            Pose start = lab.truePose("pioneer");
            lab.say("1 move 999");
            lab.await(() -> apart(start, lab.truePose("pioneer")) > 250);
            stop.send(lab);
            lab.await(lab.team().member(1)::isIdle);
            Pose end = lab.truePose("pioneer");
            lab.run("save session \"" + saved + "\"");
            assertThat(apart(start, end)).isBetween(250.0, 500.0);
            assertThat(apart(start, replayed("pioneer", saved))).isLessThan(apart(start, end) + NEAR_MM);
        }
    }

    @Test
    void drivingByHandThatASecondStopEndedGoesNoFurtherAgain() throws InterruptedException {
        Path saved = folder.resolve("hand-stopped.majic");
        try (LabRig lab = LabRig.exact()) {
            lab.run("add sim:pioneer");
            Pose start = lab.truePose("pioneer");
            Member member = lab.team().member(1);
            lab.team().stopAll();
            lab.await(member::isIdle);
            lab.team().release();
            ManualControl hand = new ManualControl(member);
            drive(lab, hand, 0, 8);
            lab.team().stopAll();
            lab.await(() -> hand.isOff() && !member.bot().state().moving());
            Pose end = lab.truePose("pioneer");
            lab.run("save session \"" + saved + "\"");
            Pose again = replayed("pioneer", saved);
            assertThat(apart(start, end)).isGreaterThan(100);
            assertThat(apart(start, again)).isLessThan(apart(start, end) + NEAR_MM);
            assertThat(apart(again, end)).isLessThan(BRAKED_MM);
        }
    }

    @Test
    void drivingByHandIsDoneAgain() throws InterruptedException {
        Path saved = folder.resolve("hand.majic");
        try (LabRig lab = LabRig.exact()) {
            lab.run("add sim:pioneer");
            Pose start = lab.truePose("pioneer");
            Member member = lab.team().member(1);
            ManualControl hand = new ManualControl(member);
            drive(lab, hand, 0, 10);
            drive(lab, hand, 20, 10);
            hand.close();
            lab.await(() -> hand.isOff() && !member.bot().state().moving());
            Pose end = lab.truePose("pioneer");
            lab.run("save session \"" + saved + "\"");
            Pose again = replayed("pioneer", saved);
            assertThat(apart(start, end)).isGreaterThan(500);
            assertThat(apart(start, again)).isLessThan(apart(start, end) + NEAR_MM);
            assertThat(apart(again, end)).isLessThan(BRAKED_MM);
        }
    }
}
