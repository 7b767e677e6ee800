package majic.gui.editor;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JRootPane;
import javax.swing.JTabbedPane;
import javax.swing.TransferHandler.TransferSupport;
import majic.gui.TestWindow;
import majic.gui.kit.FileDrop;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;

/** The script editor of a window, operated by a test. */
final class TestEditor {
    private final TestWindow window;
    private final Path folder;

    /**
     * Opens nothing yet.
     *
     * @param window the main window
     * @param folder where the scripts are written
     */
    TestEditor(TestWindow window, Path folder) {
        this.window = window;
        this.folder = folder;
    }

    Path script(String name, String... lines) throws IOException {
        return Files.writeString(file(name), String.join("\n", lines));
    }

    Path file(String name) {
        return folder.resolve(name);
    }

    /** Writes a script and opens it, as {@link #drop(Path)} does. */
    RSyntaxTextArea open(String name, String... lines) throws IOException {
        return drop(script(name, lines));
    }

    /** Drops a file on the main window, and waits until it is in the editor. */
    RSyntaxTextArea drop(Path file) {
        JRootPane pane = window.frame().getRootPane();
        TransferSupport dragged = dragOver(pane, file);
        window.run(() -> {
            assertThat(pane.getTransferHandler().canImport(dragged)).isTrue();
            pane.getTransferHandler().importData(dragged);
        });
        String name = file.getFileName().toString();
        window.await(name + " in the editor", () -> isTitle(0, name) || isTitle(1, name));
        RSyntaxTextArea area = window.awaitShowing("script", RSyntaxTextArea.class);
        window.focus(area);
        return area;
    }

    /** Returns a file that is dragged over a component, once this accepts files. */
    TransferSupport dragOver(JComponent target, Path file) {
        window.await(target.getName() + " to accept files", () -> target.getTransferHandler() instanceof FileDrop);
        return new TransferSupport(target, new DraggedFile(file));
    }

    /** Returns whether the name on a tab ends with a text. */
    boolean isTitle(int tab, String name) {
        if (!window.isShowing("scripts")) {
            return false;
        }
        JTabbedPane tabs = window.find("scripts", JTabbedPane.class);
        return tab < tabs.getTabCount() && tabs.getTitleAt(tab).endsWith(name);
    }

    void awaitStatus(String status) {
        window.await(
                "the status \"" + status + "\"",
                () -> window.text("scriptStatus").startsWith(status));
    }

    void awaitCompletions(boolean open) {
        window.await("the completions", () -> open == window.isShowing("choicesWindow"));
    }

    JFrame frame() {
        return window.find("editor", JFrame.class);
    }

    /** Closes the editor's window, as its button does. */
    void close() {
        JFrame frame = frame();
        window.run(() -> frame.dispatchEvent(new WindowEvent(frame, WindowEvent.WINDOW_CLOSING)));
    }

    /** Holds one dragged file. */
    private record DraggedFile(Path file) implements Transferable {
        @Override
        public DataFlavor[] getTransferDataFlavors() {
            return new DataFlavor[] {DataFlavor.javaFileListFlavor};
        }

        @Override
        public boolean isDataFlavorSupported(DataFlavor flavor) {
            return flavor.equals(DataFlavor.javaFileListFlavor);
        }

        @Override
        public Object getTransferData(DataFlavor flavor) {
            return List.of(file.toFile());
        }
    }
}
