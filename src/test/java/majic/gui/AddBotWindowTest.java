package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import javax.swing.JComboBox;
import majic.environment.Settings;
import majic.gui.add.AddBotDialog;
import majic.gui.add.RecentRobots;
import majic.gui.kit.ProgramServices;
import majic.recorder.RecordingFolder;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

class AddBotWindowTest {
    private static final int SHORT_MS = 300;

    @AutoClose
    private final TestWindow window = TestWindow.open();

    @Test
    void theMenuStartsTheLabAndAddsItsRobots() {
        window.run(() -> window.entry("Start the Simulated Lab").doClick());
        window.await("the lab's robot", () -> window.tabs().contains("1"));
    }

    @Test
    void aRobotThatAnswersJoinsTheTeam() {
        window.click("Add Bot");
        connectTo("here");
        window.await("its tab", () -> window.tabs().contains("1"));
        window.await("the dialog to close", () -> !window.isShowing("Add Bot dialog"));
        assertThat(window.frame.getBot(1).isConnected()).isTrue();
    }

    @Test
    void aRobotThatDoesNotAnswerLeavesAMessageWithWhatToTry() {
        window.click("Add Bot");
        connectTo("absent");
        window.await("the reason", () -> window.text("outcome").contains("nothing answers at //absent:4242"));
        assertThat(window.text("outcome")).contains("Wind the toy up.");
        assertThat(window.frame.totalBots()).isZero();
    }

    @Test
    void anAttemptThatHangsIsEndedAndItsRobotClosed() {
        window.run(() ->
                new AddBotDialog(window.frame, window.session, services(), member -> {}, SHORT_MS).setVisible(true));
        connectTo("silent");
        window.await("giving up", () -> window.text("outcome").contains("Wind the toy up."));
        window.await(
                "the robot to be closed", () -> window.type.made.get(0).told.contains("shut"));
    }

    @Test
    void cancelGivesUpAtOnce() {
        window.click("Add Bot");
        connectTo("silent");
        window.await("the attempt", () -> !window.type.made.isEmpty());
        window.click("Cancel");
        window.await(
                "the robot to be closed", () -> window.type.made.get(0).told.contains("shut"));
        assertThat(window.isShowing("Add Bot dialog")).isFalse();
    }

    @Test
    void anEmptyHostIsReported() {
        window.click("Add Bot");
        window.click("OK");
        assertThat(window.text("outcome")).startsWith("Host: fill in");
    }

    @Test
    void theEntryOfTheLabStartsTheLab() {
        window.click("Add Bot");
        window.awaitDialog("Add Bot");
        window.run(() -> window.find("type", JComboBox.class).setSelectedItem("A robot of the simulated lab"));
        window.push("startLab");
        window.awaitShowing("labRobot", JComboBox.class);
        window.push("OK");
        window.await("its tab", () -> window.tabs().contains("1"));
    }

    @Test
    void anEarlierRobotFillsInItsAddress() {
        new RecentRobots(window.settings).keep(List.of("toy://other:1", "toy://bench:77"));
        window.click("Add Bot");
        JComboBox<?> recent = window.awaitShowing("recentRobots", JComboBox.class);
        assertThat(recent.getItemAt(1)).isEqualTo("toy://bench:77");
        window.run(() -> recent.setSelectedIndex(1));
        assertThat(window.text("host")).isEqualTo("bench");
        assertThat(window.text("port")).isEqualTo("77");
    }

    private void connectTo(String host) {
        window.awaitDialog("Add Bot");
        window.focus("host");
        window.type(host);
        window.click("OK");
    }

    private static ProgramServices services() {
        RecordingFolder recordings = new RecordingFolder(Path.of("no recordings"));
        return new ProgramServices(List::of, null, () -> {}, Settings.inMemory(), recordings, null, null, null);
    }
}
