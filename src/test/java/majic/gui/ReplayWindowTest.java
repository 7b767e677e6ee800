package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Container;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JSlider;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.ListModel;
import javax.swing.SwingUtilities;
import majic.bot.Pose;
import majic.gui.replay.RecordingsDialog;
import majic.gui.replay.ReplayServices;
import majic.gui.replay.ReplayWindow;
import majic.panel.PlotHost;
import majic.recorder.RecordedText;
import majic.recorder.Recorder;
import majic.recorder.RecordingFolder;
import majic.text.MarkedTexts;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ReplayWindowTest {
    /** What is shown without being a text: the type of the robot. */
    private static final Pattern DATA = Pattern.compile("Toy");

    @TempDir
    private Path folder;

    @AutoClose
    private final TestWindow window = TestWindow.open();

    private final List<String> problems = new CopyOnWriteArrayList<>();

    /** Records a toy that reports two places. */
    private Path recorded() throws Exception {
        return recorded(1);
    }

    /** Records toys, of which the first reports two places. */
    private Path recorded(int toys) throws Exception {
        RecordingFolder recordings = new RecordingFolder(folder.resolve("recordings"));
        try (Recorder recorder = new Recorder(window.team, window.factory, recordings, problems::add)) {
            window.session.addListener(recorder);
            recorder.start();
            ToyBot toy = window.add("one");
            for (int number = 2; number <= toys; number++) {
                window.add("toy" + number);
            }
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
    void theReplayHasItsOwnStopAndLeavesTheLargeOneInView() throws Exception {
        open(recorded());
        Window replay = window.awaitShowing("replay", Window.class);
        JButton large = window.find("stop", JButton.class);
        window.run(() -> assertThat(
                        new Rectangle(large.getLocationOnScreen(), large.getSize()).intersects(replay.getBounds()))
                .isFalse());
        window.click("smallStop");
        window.await("the latch", window.team::isLatched);
        window.await("the word", () -> window.text("smallStop").equals("STOPPED"));
    }

    @Test
    void theRecordingsAreListedWithTheirLengthAndRobots() throws Exception {
        Path file = recorded(2);
        ReplayServices services = new ReplayServices(window.settings, List.of(window.type), window.frame::stopButton);
        RecordingFolder recordings = new RecordingFolder(file.getParent());
        window.run(() -> new RecordingsDialog(window.frame, recordings, services).setVisible(true));
        ListModel<?> list = window.awaitShowing("recordings", JList.class).getModel();
        window.await(
                "the robots",
                () -> list.getSize() == 1 && list.getElementAt(0).toString().endsWith("1 Toy, 2 Toy"));
        assertThat(list.getElementAt(0).toString()).containsPattern("length \\d+:\\d\\d\\.\\d");
    }

    @Test
    void theTimeSliderIsWiderThanTheOtherControls() throws Exception {
        open(recorded());
        JSlider timeline = window.awaitShowing("timeline", JSlider.class);
        window.await(
                "the layout",
                () -> timeline.getWidth()
                        > 2 * window.find("replaySpeed", JComboBox.class).getWidth());
    }

    @Test
    void theTabsOfManyRobotsAreAllVisible() throws Exception {
        open(recorded(12));
        JTabbedPane robots = window.awaitShowing("replayRobots", JTabbedPane.class);
        window.await("all tabs", () -> robots.getTabCount() == 12 && robots.getWidth() > 0);
        window.run(() -> robots.setSelectedIndex(11));
        Rectangle room = new Rectangle(robots.getSize());
        window.await(
                "all of them in view",
                () -> IntStream.range(0, 12).mapToObj(robots::getBoundsAt).allMatch(room::contains));
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

    /** Writes a part of a recording that lasts 10 s; a toy drives 100 mm in each. */
    private Path part(int number) throws Exception {
        int beginS = 10 * (number - 1);
        return RecordedText.write(
                folder.resolve("part" + number + RecordingFolder.ENDING),
                "majic-recording\t1\t2026-11-22T11:30:05Z\t" + number + "\t" + beginS + ".000",
                "\trobot\t1\ttoy\tToy\tToys\t200\t\t0\t0\t0\t",
                "\tparameter\t1\tx\tnumber\tmm\t\t-1.0E9\t1.0E9\tahead",
                "\tvalue\t1\tx\t" + 10 * beginS,
                beginS + 9.9 + "\tvalue\t1\tx\t" + (10 * beginS + 100));
    }

    @Test
    void theButtonsGoToTheNextPartOfARecordingAndBack() throws Exception {
        Path first = part(1);
        part(2);
        open(first);
        window.awaitShowing("nextPart", JButton.class);
        assertThat(window.isEnabled("previousPart")).isFalse();
        window.push("nextPart");
        window.await("the second part", () -> reading("x").equals("100 mm"));
        assertThat(window.text("replayBand")).endsWith("part 2");
        assertThat(window.isEnabled("nextPart")).isFalse();
        window.push("previousPart");
        window.await("the first part", () -> reading("x").equals("0 mm"));
    }

    @Test
    void playingGoesOnWithTheNextPart() throws Exception {
        Path first = part(1);
        part(2);
        open(first);
        window.awaitShowing("play", JButton.class);
        JComboBox<?> speed = window.find("replaySpeed", JComboBox.class);
        window.run(() -> speed.setSelectedIndex(speed.getItemCount() - 1));
        window.push("play");
        window.await("the end of the second part", () -> reading("x").equals("200 mm"));
        window.await("the pause", () -> window.text("play").equals("Play"));
    }

    @Test
    void ctrlWClosesTheReplay() throws Exception {
        open(recorded());
        JFrame replay = window.awaitShowing("replay", JFrame.class);
        window.await("the focus", replay::isFocused);
        window.pressWithCtrl(KeyEvent.VK_W);
        window.await("the end of the replay", () -> !replay.isDisplayable());
    }

    @Test
    void aRecordingOfOnePartHasNoButtonsForParts() throws Exception {
        open(part(1));
        window.awaitShowing("play", JButton.class);
        assertThat(window.isShowing("nextPart")).isFalse();
    }

    @Test
    void aPartThatCannotBeReadIsReportedWithTheReason() throws Exception {
        Path first = part(1);
        Path second = part(2);
        open(first);
        window.awaitShowing("nextPart", JButton.class);
        Files.delete(second);
        window.push("nextPart");
        window.await("the reason", () -> window.text("replayNote").contains("part2.majicrec"));
        assertThat(window.isEnabled("nextPart")).isTrue();
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

    @Test
    @SuppressWarnings("try")
    void everyTextIsFromAResourceBundle() throws Exception {
        Path file = recorded();
        Locale before = Locale.getDefault();
        try (MarkedTexts marked = new MarkedTexts()) {
            window.run(() -> Language.use(marked.language()));
            open(file);
            JLabel band = window.awaitShowing("replayBand", JLabel.class);
            Container root = SwingUtilities.getWindowAncestor(band);
            window.run(() -> assertThat(WindowAudit.unmarked(root, DATA)).isEmpty());
        } finally {
            window.run(() -> Language.use(before));
        }
    }
}
