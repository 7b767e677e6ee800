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
 * Tells when a component comes into a person's sight and when it goes out of it: a hidden tab is out of sight, and so is
 * what lies in an iconified window, which Swing takes for showing. For the event dispatch thread.
 */
final class Sight {
    private final Component component;
    private final Consumer<Boolean> audience;
    private final WindowStateListener states = this::changed;
    private @Nullable Window window;
    private boolean seen;

    /**
     * Watches over a component that cannot be seen yet.
     *
     * @param audience told of each change
     */
    Sight(Component component, Consumer<Boolean> audience) {
        this.component = component;
        this.audience = audience;
        component.addHierarchyListener(change -> {
            if ((change.getChangeFlags() & HierarchyEvent.SHOWING_CHANGED) != 0) {
                follow(component.isShowing() ? SwingUtilities.getWindowAncestor(component) : null);
            }
        });
    }

    /** Takes the component for out of sight: it leaves its window. */
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
        tell(now != null && !isIcon(now));
    }

    private static boolean isIcon(Window window) {
        return window instanceof Frame frame && (frame.getExtendedState() & Frame.ICONIFIED) != 0;
    }

    private void changed(WindowEvent change) {
        tell(component.isShowing() && (change.getNewState() & Frame.ICONIFIED) == 0);
    }

    private void tell(boolean now) {
        if (now != seen) {
            seen = now;
            audience.accept(now);
        }
    }
}
