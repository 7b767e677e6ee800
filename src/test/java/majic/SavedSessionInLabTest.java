package majic;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import majic.bot.Pose;
import majic.team.ManualControl;
import majic.team.Member;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that running a saved session again moves a simulated robot to the same place. */
@Timeout(60)
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

    @Test
    void drivingByHandIsDoneAgain() throws InterruptedException {
        Path saved = folder.resolve("hand.majic");
        try (LabRig lab = LabRig.exact()) {
            lab.run("add sim:pioneer");
            Pose start = lab.truePose("pioneer");
            Member member = lab.team().member(1);
            ManualControl hand = new ManualControl(member);
            for (int tick = 0; tick < 20; tick++) {
                hand.drive(200, tick < 10 ? 0 : 20);
                lab.lab().time().sleep(0.15);
            }
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
