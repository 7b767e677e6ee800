package majic.gui.replay;

import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.when;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.util.List;
import javax.swing.JPanel;
import majic.environment.Settings;
import majic.gui.TestWindow;
import majic.recorder.RecordingFolder;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

class RecordingsDialogWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    @Test
    void aFolderThatCannotBeReadIsNamedAsTheReason() throws IOException {
        RecordingFolder folder = mock();
        when(folder.files()).thenThrow(new AccessDeniedException("recordings"));
        ReplayServices services = new ReplayServices(Settings.inMemory(), List.of(), JPanel::new);
        window.run(() -> new RecordingsDialog(window.frame(), folder, services).setVisible(true));

        window.await(
                "the reason",
                () -> window.text("recordingProblem").equals("The recordings cannot be listed (it is not allowed)"));
    }
}
