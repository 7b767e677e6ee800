package majic.gui.replay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Component;
import java.awt.Container;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import majic.bot.BotType;
import majic.bot.MajicBot;
import majic.inlab.LabRig;
import majic.panel.RefreshingPanel;
import majic.recorder.Recorder;
import majic.recorder.Recording;
import majic.recorder.RecordingFolder;
import majic.recorder.Series;
import majic.team.Member;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** In a replay the panels of all robots show what they showed when it was recorded. */
class ReplayPanelsInLabTest {
    @TempDir
    private Path folder;

    private final Map<Integer, Map<String, String>> recorded = new TreeMap<>();
    private final Map<Integer, Map<String, String>> replayed = new TreeMap<>();

    @Test
    void aReplayedPanelShowsTheTextsOfTheRobotsPanel() throws Exception {
        SwingUtilities.invokeAndWait(FlatLightLaf::setup);
        RecordingFolder files = new RecordingFolder(folder);
        try (LabRig rig = LabRig.exactWithRos("2")) {
            Recorder recorder = new Recorder(rig.team(), rig.session().factory(), files, problem -> {});
            recorder.start();
            rig.withAllRobots();
            rig.run("2 move 300", "1 set headPan 20", "3 move 100", "3 set ledLeft on", "4 move 200", "wait 2s");
            recorder.close();
            for (Member member : rig.team().members()) {
                SwingUtilities.invokeAndWait(
                        () -> recorded.put(member.number(), texts(member.bot().display())));
            }
            replay(Recording.read(files.files().get(0)), rig.session().factory().types());
        }
        // Counts the questions to the Hemisson, which go on after the last sample.
        recorded.get(3).remove("missedAnswers");
        recorded.forEach((number, texts) ->
                assertThat(replayed.get(number)).as("robot " + number).containsAllEntriesOf(texts));
        assertThat(recorded.get(2)).containsEntry("motors", "motors on");
        assertThat(recorded.get(4))
                .containsEntry("model", "TurtleBot3 Burger (ROS 2)")
                .containsEntry("scanner", "scan ok");
    }

    @Test
    void aReplayedCopterHasItsPanelItsHeightOnTheMapAndItsCurve() throws Exception {
        SwingUtilities.invokeAndWait(FlatLightLaf::setup);
        RecordingFolder files = new RecordingFolder(folder);
        try (LabRig rig = LabRig.exactWithMavlink("copter+ready")) {
            Recorder recorder = new Recorder(rig.team(), rig.session().factory(), files, problem -> {});
            recorder.start();
            MajicBot copter = rig.add("mavlink");
            rig.lab().time().sleep(2);
            rig.run("1 set fence 5000 500 5000", "1 arm", "1 takeoff 2000", "1 move 500", "wait 2s");
            assertThat(recorder.history().series(1, "altitude", 0).size()).isGreaterThan(10);
            recorder.close();
            SwingUtilities.invokeAndWait(() -> recorded.put(1, texts(copter.display())));
            Recording recording = Recording.read(files.files().get(0));
            replay(recording, rig.session().factory().types());

            double height = onMap(rig.session().factory().type("mavlink"), recording, recording.endS());
            assertThat(height).isCloseTo(copter.heightMm().orElseThrow(), within(100.0));
            assertThat(onMap(rig.session().factory().type("mavlink"), recording, recording.beginS() + 1))
                    .isZero();
            Series altitude = recording.series(1, "altitude", 0);
            assertThat(altitude.values()[0]).isBetween(-100.0, 100.0);
            assertThat(altitude.values()[altitude.size() - 1]).isBetween(1700.0, 2300.0);
        }
        assertThat(replayed.get(1)).containsAllEntriesOf(recorded.get(1));
        assertThat(recorded.get(1)).containsEntry("armed", "ARMED").containsEntry("failsafe", "no failsafe");
    }

    private static double onMap(BotType type, Recording recording, double atS) throws Exception {
        ReplayRobot[] made = new ReplayRobot[1];
        SwingUtilities.invokeAndWait(
                () -> made[0] = new ReplayRobot(type, recording.tracks().get(0)));
        try (ReplayRobot robot = made[0]) {
            return robot.onMap(recording, atS).heightMm();
        }
    }

    private void replay(Recording recording, List<BotType> types) throws Exception {
        for (int index = 0; index < recording.tracks().size(); index++) {
            int number = index + 1;
            ReplayRobot[] made = new ReplayRobot[1];
            SwingUtilities.invokeAndWait(() -> made[0] = new ReplayRobot(
                    type(types, recording, number), recording.tracks().get(number - 1)));
            made[0].jump(recording.endS());
            SwingUtilities.invokeAndWait(
                    () -> replayed.put(number, texts(made[0].display().component())));
            made[0].close();
        }
    }

    private static BotType type(List<BotType> types, Recording recording, int number) {
        return types.stream()
                .filter(type ->
                        type.name().equals(recording.robots().get(number - 1).type()))
                .findFirst()
                .orElseThrow();
    }

    /** The texts of all labels that have a name. */
    private static Map<String, String> texts(JComponent panel) {
        panel.addNotify();
        ((RefreshingPanel) panel).refreshIfChanged();
        Map<String, String> texts = new TreeMap<>();
        collect(panel, texts);
        panel.removeNotify();
        return texts;
    }

    private static void collect(Container parts, Map<String, String> texts) {
        for (Component part : parts.getComponents()) {
            if (part instanceof JLabel label && label.getName() != null) {
                texts.put(label.getName(), label.getText());
            } else if (part instanceof Container inner) {
                collect(inner, texts);
            }
        }
    }
}
