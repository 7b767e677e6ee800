package majic.gui.replay;

import static org.assertj.core.api.Assertions.assertThat;

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
import majic.inlab.LabRig;
import majic.panel.RefreshingPanel;
import majic.recorder.Recorder;
import majic.recorder.Recording;
import majic.recorder.RecordingFolder;
import majic.team.Member;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** In a replay the panels of all four robots show what they showed when it was recorded. */
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

    private void replay(Recording recording, List<BotType> types) throws Exception {
        for (int index = 0; index < 4; index++) {
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
