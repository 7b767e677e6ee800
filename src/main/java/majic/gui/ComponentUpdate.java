package majic.gui;

import java.awt.Component;
import java.awt.Container;
import java.awt.Window;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JMenu;
import majic.gui.kit.EventThread;

/**
 * Updates the components of a window to the present look and feel in pieces of the event dispatch thread, where
 * {@link javax.swing.SwingUtilities#updateComponentTreeUI} would update all of them in one event.
 */
final class ComponentUpdate {
    /** The time after which the next piece begins, ns. */
    private static final long PIECE_NANOS = 15_000_000;

    private final Window window;

    /** Each behind its children, so that what it sets on them stays. */
    private final Deque<Component> waiting = new ArrayDeque<>();

    private ComponentUpdate(Window window) {
        this.window = window;
        collect(window);
    }

    private void collect(Component component) {
        waiting.push(component);
        if (component instanceof JComponent updated && updated.getComponentPopupMenu() != null) {
            collect(updated.getComponentPopupMenu());
        }
        children(component).forEach(this::collect);
    }

    private static List<Component> children(Component component) {
        if (component instanceof JMenu menu) {
            return List.of(menu.getMenuComponents());
        }
        return component instanceof Container container ? List.of(container.getComponents()) : List.of();
    }

    /** Begins to update a window; must be called on the event dispatch thread. */
    static void begin(Window window) {
        EventThread.piece(new ComponentUpdate(window)::continued);
    }

    private void continued() {
        long beganNanos = System.nanoTime();
        while (!waiting.isEmpty() && System.nanoTime() - beganNanos < PIECE_NANOS) {
            if (waiting.pop() instanceof JComponent component) {
                component.updateUI();
            }
        }
        EventThread.piece(waiting.isEmpty() ? this::show : this::continued);
    }

    private void show() {
        window.invalidate();
        window.validate();
        window.repaint();
    }
}
