package majic.gui.kit;

import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.event.InputEvent;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.TransferHandler;
import org.jspecify.annotations.Nullable;

/** Accepts files that are dropped on a component; all else is left to the handler that the component had before. */
public final class FileDrop extends TransferHandler {
    private static final long serialVersionUID = 1L;

    private final transient Consumer<List<Path>> dropped;
    private final @Nullable TransferHandler other;

    private FileDrop(Consumer<List<Path>> dropped, @Nullable TransferHandler other) {
        this.dropped = dropped;
        this.other = other;
    }

    /**
     * Makes a component accept files.
     *
     * @param dropped receives them
     */
    public static void install(JComponent component, Consumer<List<Path>> dropped) {
        component.setTransferHandler(new FileDrop(dropped, component.getTransferHandler()));
    }

    @Override
    public boolean canImport(TransferSupport support) {
        return hasFiles(support) || (other != null && other.canImport(support));
    }

    private static boolean hasFiles(TransferSupport support) {
        return support.isDataFlavorSupported(DataFlavor.javaFileListFlavor);
    }

    @Override
    public boolean importData(TransferSupport support) {
        if (!hasFiles(support)) {
            return other != null && other.importData(support);
        }
        try {
            List<?> files = (List<?>) support.getTransferable().getTransferData(DataFlavor.javaFileListFlavor);
            dropped.accept(files.stream().map(file -> ((File) file).toPath()).toList());
            return true;
        } catch (UnsupportedFlavorException | IOException e) {
            return false;
        }
    }

    @Override
    public int getSourceActions(JComponent component) {
        return other == null ? NONE : other.getSourceActions(component);
    }

    @Override
    public void exportToClipboard(JComponent component, Clipboard clipboard, int action) {
        if (other != null) {
            other.exportToClipboard(component, clipboard, action);
        }
    }

    @Override
    public void exportAsDrag(JComponent component, InputEvent event, int action) {
        if (other != null) {
            other.exportAsDrag(component, event, action);
        }
    }
}
