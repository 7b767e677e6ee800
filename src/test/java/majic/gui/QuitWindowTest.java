package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.JMenu;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(60)
class QuitWindowTest {
    @Test
    void unsavedScriptsAreAskedForBeforeTheProgramEnds(@TempDir Path folder) throws IOException {
        Path file = Files.writeString(folder.resolve("lap.majic"), "1 move 30");
        try (TestWindow window = TestWindow.openWith("editor.recent", "" + file)) {
            JMenu recent = (JMenu) window.frame.getJMenuBar().getMenu(0).getItem(2);
            window.run(() -> recent.setSelected(true));
            window.run(() -> recent.getItem(0).doClick());
            RSyntaxTextArea area = window.awaitShowing("script", RSyntaxTextArea.class);
            window.run(() -> area.append("\n1 stop"));
            window.run(window.frame::quit);
            window.awaitDialog("Unsaved Script");
            assertThat(window.quits).hasValue(0);
            window.push("Don't save");
            window.await("the end", () -> window.quits.get() == 1);
            assertThat(file).hasContent("1 move 30");
        }
    }
}
