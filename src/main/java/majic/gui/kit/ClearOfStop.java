package majic.gui.kit;

import java.awt.Component;
import java.awt.Container;
import java.awt.Rectangle;
import java.awt.Window;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JComponent;

/**
 * Places windows where they do not cover the large STOP of the main window. Must be used on the event dispatch thread.
 */
public final class ClearOfStop {
    private static final String MARK = "majic.largeStop";
    private static final int GAP = 8;

    private ClearOfStop() {}

    /** Makes a component the one that is not covered. */
    public static void mark(JComponent stop) {
        stop.putClientProperty(MARK, true);
    }

    /**
     * Moves a window that would cover STOP below it, or to its left; makes it smaller if the screen has not enough room
     * there.
     *
     * @param window has a place and a size, and is not visible yet
     * @param owner the window with STOP, or one that this owns
     */
    public static void place(Window window, Window owner) {
        Rectangle screen = owner.getGraphicsConfiguration().getBounds();
        Stream.iterate(owner, Objects::nonNull, Window::getOwner)
                .flatMap(shown -> stop(shown).stream())
                .findFirst()
                .ifPresent(stop ->
                        window.setBounds(clear(window.getBounds(), window.getMinimumSize().height, stop, screen)));
    }

    /** Returns the nearest place beside STOP. */
    static Rectangle clear(Rectangle window, int leastHeight, Rectangle stop, Rectangle screen) {
        if (!window.intersects(stop)) {
            return window;
        }
        int below = stop.y + stop.height + GAP;
        int room = screen.y + screen.height - below;
        if (room >= leastHeight) {
            int height = Math.min(window.height, room);
            return new Rectangle(window.x, below, window.width, height);
        }
        int width = Math.min(window.width, Math.max(1, stop.x - GAP - screen.x));
        return new Rectangle(Math.min(window.x, stop.x - GAP - width), window.y, width, window.height);
    }

    private static Optional<Rectangle> stop(Container container) {
        return all(container)
                .filter(found -> found instanceof JComponent part && part.getClientProperty(MARK) != null)
                .filter(Component::isShowing)
                .map(found -> new Rectangle(found.getLocationOnScreen(), found.getSize()))
                .findFirst();
    }

    private static Stream<Component> all(Container container) {
        return Stream.of(container.getComponents())
                .flatMap(part ->
                        Stream.concat(Stream.of(part), part instanceof Container inner ? all(inner) : Stream.empty()));
    }
}
