package majic.gui.replay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.when;

import java.awt.Container;
import java.awt.Rectangle;
import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.util.List;
import javax.swing.JDialog;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
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

    @Test
    void theWholeReasonFitsIntoTheDialogThatIsOpenAlready() throws IOException {
        RecordingFolder folder = mock();
        when(folder.files()).thenReturn(List.of());
        ReplayServices services = new ReplayServices(Settings.inMemory(), List.of(), JPanel::new);
        window.run(() -> new RecordingsDialog(window.frame(), folder, services).setVisible(true));

        window.await("the reason", () -> window.text("recordingProblem").startsWith("There is no recording yet"));
        JTextArea problem = window.find("recordingProblem", JTextArea.class);
        window.await("its whole text", () -> problem.getHeight() >= problem.getPreferredSize().height);
        Container content = ((JDialog) SwingUtilities.getWindowAncestor(problem)).getContentPane();
        Rectangle bounds = SwingUtilities.convertRectangle(problem.getParent(), problem.getBounds(), content);
        assertThat(new Rectangle(content.getSize()).contains(bounds)).isTrue();
    }
}
