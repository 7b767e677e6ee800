package majic.gui.replay;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import javax.swing.SwingUtilities;
import majic.bot.BotType;
import majic.bot.Pose;
import majic.gui.ToyType;
import majic.gui.map.MapScene;
import majic.recorder.RecordedText;
import majic.recorder.Recording;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A recorded robot on the map of the replay. */
class ReplayRobotTest {
    @TempDir
    private Path folder;

    @Test
    void itsWayIsSeenFromWhereTheRobotStarted() throws Exception {
        Recording recording = Recording.read(RecordedText.write(
                folder.resolve("a.majicrec"),
                "majic-recording\t1\t2026-11-22T11:30:05Z\t1\t0.000",
                "1.000\trobot\t2\ttoy\tToy\tToy\t250\t\t100\t0\t90\ttoy",
                "2.000\tstatus\t2\tway\t700 0",
                "4.000\tstatus\t2\tway\t"));
        try (ReplayRobot robot = robot(recording)) {
            assertThat(robot.onMap(recording, 1).way()).isEqualTo(MapScene.PlannedWay.NONE);
            assertThat(robot.onMap(recording, 3).way().corners().get(0).distanceMm(new Pose(100, 700, 0)))
                    .isLessThan(1);
            assertThat(robot.onMap(recording, 4).way()).isEqualTo(MapScene.PlannedWay.NONE);
        }
    }

    @Test
    void anAircraftHasItsHeightWhileThatWasKnown() throws Exception {
        Recording recording = Recording.read(RecordedText.write(
                folder.resolve("a.majicrec"),
                "majic-recording\t1\t2026-11-22T11:30:05Z\t1\t0.000",
                "1.000\trobot\t2\ttoy\tToy\tToy\t250\t\t0\t0\t0\t",
                "1.000\tparameter\t2\taltitude\tnumber\tmm\t\t-Infinity\tInfinity\tabove its home position",
                "1.000\tvalue\t2\taltitude\t1500",
                "2.000\tstatus\t2\taircraft\tyes",
                "3.000\tvalue\t2\taltitude\t1730",
                "4.000\tvalue\t2\taltitude\t?"));
        try (ReplayRobot robot = robot(recording)) {
            assertThat(robot.onMap(recording, 1.5).heightMm()).isZero();
            assertThat(robot.onMap(recording, 2).heightMm()).isEqualTo(1500);
            assertThat(robot.onMap(recording, 3).heightMm()).isEqualTo(1700);
            assertThat(robot.onMap(recording, 4).heightMm()).isZero();
        }
    }

    private static ReplayRobot robot(Recording recording) throws Exception {
        CompletableFuture<ReplayRobot> made = new CompletableFuture<>();
        SwingUtilities.invokeAndWait(() -> made.complete(new ReplayRobot(
                new ToyType(BotType.Reach.TCP), recording.tracks().get(0))));
        return made.get();
    }
}
