package majic.panel;

import java.awt.Component;
import java.awt.Frame;
import java.awt.Window;
import java.awt.event.HierarchyEvent;
import java.awt.event.WindowEvent;
import java.awt.event.WindowStateListener;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import org.jspecify.annotations.Nullable;

/**
 * Reports when a component becomes visible to the user or is hidden: a component on a hidden tab is not visible, nor is
 * one in an iconified window, which Swing reports as showing. Must be used on the event dispatch thread.
 */
public final class VisibilityWatch {
    private final Component component;
    private final Consumer<Boolean> listener;
    private final WindowStateListener states = this::changed;
    private @Nullable Window window;
    private boolean visible;

    /**
     * Creates a watch for a component that is not visible yet.
     *
     * @param component the component to watch
     * @param listener receives each change: whether it is visible now
     */
    public VisibilityWatch(Component component, Consumer<Boolean> listener) {
        this.component = component;
        this.listener = listener;
        component.addHierarchyListener(change -> {
            if ((change.getChangeFlags() & HierarchyEvent.SHOWING_CHANGED) != 0) {
                follow(component.isShowing() ? SwingUtilities.getWindowAncestor(component) : null);
            }
        });
    }

    /** Reports the component as hidden, since it is removed from its window. */
    void end() {
        follow(null);
    }

    private void follow(@Nullable Window now) {
        if (window != null) {
            window.removeWindowStateListener(states);
        }
        window = now;
        if (now != null) {
            now.addWindowStateListener(states);
        }
        report(now != null && !isIcon(now));
    }

    private static boolean isIcon(Window window) {
        return window instanceof Frame frame && (frame.getExtendedState() & Frame.ICONIFIED) != 0;
    }

    private void changed(WindowEvent change) {
        report(component.isShowing() && (change.getNewState() & Frame.ICONIFIED) == 0);
    }

    private void report(boolean now) {
        if (now != visible) {
            visible = now;
            listener.accept(now);
        }
    }
}
