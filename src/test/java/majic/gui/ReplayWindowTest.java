package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Container;
import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JSlider;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import majic.bot.Pose;
import majic.gui.replay.ReplayServices;
import majic.gui.replay.ReplayWindow;
import majic.panel.PlotHost;
import majic.recorder.Recorder;
import majic.recorder.RecordingFolder;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(120)
class ReplayWindowTest {
    @TempDir
    private Path folder;

    @AutoClose
    private final TestWindow window = TestWindow.open();

    private final List<String> problems = new CopyOnWriteArrayList<>();

    /** Records a toy that reports two places. */
    private Path recorded() throws Exception {
        RecordingFolder recordings = new RecordingFolder(folder.resolve("recordings"));
        try (Recorder recorder = new Recorder(window.team, window.factory, recordings, problems::add)) {
            window.session.addListener(recorder);
            recorder.start();
            ToyBot toy = window.add("one");
            window.command("1 move 250");
            window.awaitMessage("1 move 250: done");
            toy.at(new Pose(250, 0, 0), false);
            window.session.flush();
        }
        assertThat(problems).isEmpty();
        return recordings.files().get(0);
    }

    private void open(Path file) {
        ReplayServices services = new ReplayServices(window.settings, List.of(window.type), window.frame::stopButton);
        window.run(() -> ReplayWindow.open(window.frame, file, services, () -> {}, problems::add));
    }

    private void moveTo(int percent) {
        JSlider timeline = window.awaitShowing("timeline", JSlider.class);
        window.run(() -> timeline.setValue(timeline.getMaximum() * percent / 100));
    }

    private String reading(String name) {
        JTable readings = window.find("readings", JTable.class);
        for (int row = 0; row < readings.getRowCount(); row++) {
            if (readings.getValueAt(row, 0).equals(name)) {
                return readings.getValueAt(row, 1).toString();
            }
        }
        return "";
    }

    @Test
    void theTimeSliderShowsWhatWasReportedThen() throws Exception {
        open(recorded());
        assertThat(window.awaitShowing("replayBand", JLabel.class).getText()).startsWith("REPLAY of ");
        moveTo(100);
        window.await("the last place", () -> reading("x").equals("250 mm"));
        assertThat(window.text("replayStatus1")).contains("x 250 mm");
        moveTo(0);
        window.await("the first place", () -> window.text("replayTime").startsWith("0:0"));
        window.await("the first place", () -> !reading("x").equals("250 mm"));
    }

    @Test
    void playRunsToTheEndAndPausesThere() throws Exception {
        open(recorded());
        window.awaitShowing("play", JButton.class);
        moveTo(80);
        window.push("play");
        window.await(
                "the end",
                () -> window.text("play").equals("Play") && reading("x").equals("250 mm"));
    }

    @Test
    void noRobotIsReachedFromAReplayButStopKeysStopTheTeam() throws Exception {
        open(recorded());
        window.awaitShowing("timeline", JSlider.class);
        ToyBot toy = window.type.made.get(0);
        toy.told.clear();
        moveTo(100);
        window.await("the last place", () -> reading("x").equals("250 mm"));
        assertThat(toy.told).isEmpty();
        window.focus("play");
        window.press(KeyEvent.VK_F12);
        window.await("the stop of the robot", () -> toy.told.contains("halt"));
        assertThat(window.team.isLatched()).isTrue();
    }

    @Test
    void aReadingOfAReplayOpensAPlotOfTheRecording() throws Exception {
        open(recorded());
        JTable readings = window.awaitShowing("readings", JTable.class);
        moveTo(100);
        window.await("the last place", () -> reading("x").equals("250 mm"));
        PlotHost host = (PlotHost) SwingUtilities.getAncestorOfClass(PlotHost.class, readings);
        window.run(() -> host.plot(List.of("x"), false));
        JFrame plot = window.awaitShowing("plot", JFrame.class);
        assertThat(plot.getTitle()).isEqualTo("Plot of a REPLAY: 1 x");
        window.await("the stop button", () -> window.isShowing("smallStop"));
    }

    @Test
    void aFileThatIsNoRecordingIsReportedWithTheReason() throws Exception {
        open(Files.writeString(folder.resolve("letter.majicrec"), "Dear all"));
        window.await("the reason", () -> !problems.isEmpty());
        assertThat(problems.get(0)).contains("letter.majicrec").contains("no recording");
    }

    @Test
    void itsPartsHaveNamesAndReadableTexts() throws Exception {
        open(recorded());
        JLabel band = window.awaitShowing("replayBand", JLabel.class);
        Container root = SwingUtilities.getWindowAncestor(band);
        window.run(() -> {
            assertThat(WindowAudit.nameless(root)).isEmpty();
            assertThat(WindowAudit.pale(root, Contrast.TEXT)).isEmpty();
        });
    }
}
