package majic.gui.kit;

import java.awt.Component;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.RootPaneContainer;
import org.jspecify.annotations.Nullable;

/** The section of the user's guide that explains a part of a window; F1 opens it when the focus is in that part. */
public final class HelpTopic {
    private static final String KEY = "majic.help";

    private HelpTopic() {}

    /**
     * Sets the section of a component and of all parts of it that have none; of a window, if it is its root pane.
     *
     * @param section the heading as in links: lower case, words joined by {@code -}, for instance
     *     {@code the-main-screen}
     */
    public static void set(JComponent component, String section) {
        component.putClientProperty(KEY, section);
    }

    /**
     * Returns the section of a component, of the nearest component around it that has one, or of a window that owns its
     * window.
     *
     * @param component null if nothing has the focus
     */
    public static Optional<String> of(@Nullable Component component) {
        for (Component part = component; part != null; part = part.getParent()) {
            Component holder = part instanceof RootPaneContainer window ? window.getRootPane() : part;
            if (holder instanceof JComponent known && known.getClientProperty(KEY) instanceof String section) {
                return Optional.of(section);
            }
        }
        return Optional.empty();
    }
}
