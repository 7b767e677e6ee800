package majic.gui.editor;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.JList;
import javax.swing.JRootPane;
import majic.gui.TestWindow;
import majic.recorder.Recorder;
import majic.recorder.RecordingFolder;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests what the window does with a file of each kind that is dropped on it. */
class DroppedFilesWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    private final TestEditor editor;

    DroppedFilesWindowTest(@TempDir Path folder) {
        editor = new TestEditor(window, folder);
    }

    private void drop(Path file) {
        JRootPane pane = window.frame().getRootPane();
        var dragged = editor.dragOver(pane, file);
        window.run(() -> pane.getTransferHandler().importData(dragged));
    }

    @Test
    void anActIsOfferedForTheRobotThatIsChosen() throws IOException {
        window.add("one");
        drop(editor.script("Lap.act", "no act"));
        window.awaitDialog("Load Act");
        assertThat(window.isShowing("editor")).isFalse();
        window.push("OK");
        window.awaitDialog("Choose Act");
        JList<?> acts = window.find("acts", JList.class);
        window.await("the reason why it is no act", () -> window.text("actNote").contains("Lap.act"));
        assertThat(acts.isSelectionEmpty()).isTrue();
    }

    @Test
    void anActThatIsDroppedWithoutARobotIsRefusedWithAMessage() throws IOException {
        drop(editor.script("Lap.act", "no act"));
        window.awaitMessage("no robot");
        assertThat(window.isShowing("editor")).isFalse();
    }

    @Test
    void theRobotsOfASavedTeamAreConnected() throws IOException {
        editor.script("lab.team", "add toy:one as 1");
        drop(editor.file("lab.team"));
        window.await("the robot to be connected", () -> window.team.members().size() == 1);
        assertThat(window.isShowing("editor")).isFalse();
    }

    @Test
    void aRecordingIsReplayed() throws Exception {
        RecordingFolder recordings = new RecordingFolder(editor.file("recordings"));
        try (Recorder recorder = new Recorder(window.team, window.factory, recordings, problem -> {})) {
            recorder.start();
            window.add("one");
            window.command("1 move 250");
            window.awaitMessage("1 move 250: done");
        }
        drop(recordings.files().get(0));
        window.await("the replay", () -> window.isShowing("timeline"));
        assertThat(window.isShowing("editor")).isFalse();
    }

    @Test
    void aRecordingThatCannotBeReadIsRefusedWithAMessage() throws IOException {
        drop(editor.script("old.majicrec", "no recording"));
        window.awaitMessage("old.majicrec");
    }

    @Test
    void aFileThatIsNoTextIsRefusedInTheEditor() throws IOException {
        drop(Files.write(editor.file("picture.bin"), new byte[] {1, 0, 2}));
        window.await("the reason", () -> window.isShowing("fileNotice"));
        assertThat(window.text("fileNotice")).contains("picture.bin");
    }

    @Test
    void aTeamThatIsDroppedOnTheEditorIsOpenedAsATeam() throws IOException {
        editor.open("lap.majic", "1 stop");
        JRootPane pane = editor.frame().getRootPane();
        var dragged = editor.dragOver(pane, editor.script("old.team", "no team"));
        window.run(() -> pane.getTransferHandler().importData(dragged));
        window.awaitMessage("old.team");
        assertThat(editor.isTitle(1, "old.team")).isFalse();
    }
}
