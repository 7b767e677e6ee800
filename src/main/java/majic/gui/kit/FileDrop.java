package majic.gui.kit;

import java.awt.Component;
import java.awt.Container;
import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.event.ContainerAdapter;
import java.awt.event.ContainerEvent;
import java.awt.event.ContainerListener;
import java.awt.event.InputEvent;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.CellRendererPane;
import javax.swing.JComponent;
import javax.swing.TransferHandler;
import javax.swing.text.JTextComponent;
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

    /**
     * Makes a window accept files everywhere. Its texts are the targets of what is dropped on them, so each accepts
     * files too, also one that is added later.
     *
     * @param root the window's root pane
     * @param dropped receives the files
     */
    public static void installInside(JComponent root, Consumer<List<Path>> dropped) {
        install(root, dropped);
        follow(
                root,
                new ContainerAdapter() {
                    @Override
                    public void componentAdded(ContainerEvent event) {
                        visit(event.getChild(), this, dropped);
                    }
                },
                dropped);
    }

    /**
     * Removes the targets for dropped texts that the look and feel has given to the texts of a window, so that the
     * window is visible sooner: the first target makes the toolkit ask the display for everything that it needs for
     * dragging. {@link #installInside} makes them anew.
     *
     * @param root the window's root pane; not shown yet
     */
    public static void postponeInside(Container root) {
        for (Component part : root.getComponents()) {
            if (part instanceof JTextComponent) {
                part.setDropTarget(null);
            } else if (part instanceof Container container) {
                postponeInside(container);
            }
        }
    }

    private static void follow(Container container, ContainerListener added, Consumer<List<Path>> dropped) {
        container.addContainerListener(added);
        Stream.of(container.getComponents()).forEach(part -> visit(part, added, dropped));
    }

    private static void visit(Component part, ContainerListener added, Consumer<List<Path>> dropped) {
        if (part instanceof JTextComponent text) {
            if (!(text.getTransferHandler() instanceof FileDrop)) {
                install(text, dropped);
            }
        } else if (part instanceof Container container
                && !(part instanceof CellRendererPane)
                && !List.of(container.getContainerListeners()).contains(added)) {
            follow(container, added, dropped);
        }
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
