package majic.panel;

import java.awt.Color;
import java.awt.Cursor;
import java.awt.Point;
import java.awt.dnd.DnDConstants;
import java.awt.dnd.DragGestureEvent;
import java.awt.dnd.DragSource;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import javax.swing.JComponent;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * Makes the figures of a component open plots: by a click, with Ctrl in the plot used last, by a context menu, and by
 * Enter while the component has the focus. A figure can be dragged onto an open plot. Does nothing where no
 * {@link PlotHost} contains the component, or where the host cannot plot the parameter. Must be used on the event
 * dispatch thread.
 */
public final class PlotLink {
    private static final Cursor HAND = Cursor.getPredefinedCursor(Cursor.HAND_CURSOR);
    private static final Texts TEXTS = Texts.of(PlotLink.class);

    private final JComponent component;
    private final Function<Point, List<String>> parametersAt;

    private PlotLink(JComponent component, Function<Point, List<String>> parametersAt) {
        this.component = component;
        this.parametersAt = parametersAt;
        Mouse mouse = new Mouse();
        component.addMouseListener(mouse);
        component.addMouseMotionListener(mouse);
    }

    /**
     * Links a component that shows readings as a whole.
     *
     * @param component the component; its tool tip begins with the word for a plot
     * @param parameters names of the robot's parameters
     */
    public static void install(JComponent component, List<String> parameters) {
        install(component, parameters, point -> parameters);
    }

    /**
     * Links a component that shows different readings at different places.
     *
     * @param component the component; its tool tip begins with the word for a plot, unless it makes its own ones
     * @param all names of the parameters that Enter plots; empty if the component does not get the focus
     * @param parametersAt returns the names of the parameters shown at a point of the component; empty where there are
     *     none
     */
    public static void install(JComponent component, List<String> all, Function<Point, List<String>> parametersAt) {
        PlotLink link = new PlotLink(component, parametersAt);
        if (!all.isEmpty()) {
            component.addFocusListener(new Highlight(component));
            KeyAction.bind(
                    component,
                    JComponent.WHEN_FOCUSED,
                    KeyStroke.getKeyStroke("ENTER"),
                    event -> link.plot(all, false));
        }
    }

    /**
     * Returns whether a parameter can be plotted where a component is now.
     *
     * @param component a component, in a window or not
     * @param parameter name of the robot's parameter
     */
    public static boolean isPlottable(JComponent component, String parameter) {
        return host(component).filter(host -> host.canPlot(parameter)).isPresent();
    }

    private static Optional<PlotHost> host(JComponent component) {
        return Optional.ofNullable((PlotHost) SwingUtilities.getAncestorOfClass(PlotHost.class, component));
    }

    private List<String> plottableAt(Point point) {
        return parametersAt.apply(point).stream()
                .filter(parameter -> isPlottable(component, parameter))
                .toList();
    }

    private void plot(List<String> parameters, boolean add) {
        List<String> plottable = parameters.stream()
                .filter(parameter -> isPlottable(component, parameter))
                .toList();
        if (!plottable.isEmpty()) {
            host(component).ifPresent(host -> host.plot(plottable, add));
        }
    }

    private void showMenu(Point point) {
        List<String> parameters = plottableAt(point);
        if (parameters.isEmpty()) {
            return;
        }
        String names = String.join(", ", parameters);
        JPopupMenu menu = new JPopupMenu();
        menu.add(item(TEXTS.get("plot.new", names), parameters, false));
        menu.add(item(TEXTS.get("plot.add", names), parameters, true));
        menu.show(component, point.x, point.y);
    }

    private JMenuItem item(String text, List<String> parameters, boolean add) {
        JMenuItem item = new JMenuItem(text);
        item.addActionListener(event -> plot(parameters, add));
        return item;
    }

    /** Returns a tool tip with what a click does; an empty one is made by the component itself. */
    private static String tip(@Nullable String text) {
        String click = TEXTS.get("plot");
        if (text == null) {
            return click;
        }
        return text.isEmpty() || text.startsWith(click) ? text : TEXTS.get("plot.tip", text);
    }

    private void drag(DragGestureEvent gesture) {
        List<String> parameters = plottableAt(gesture.getDragOrigin());
        if (!parameters.isEmpty()) {
            host(component).ifPresent(host -> gesture.startDrag(null, host.dragged(parameters)));
        }
    }

    private final class Mouse extends MouseAdapter {
        private boolean draggable;

        /** Prepares dragging, which costs time that panels do not have when the window opens. */
        @Override
        public void mouseEntered(MouseEvent event) {
            if (!draggable) {
                draggable = true;
                DragSource.getDefaultDragSource()
                        .createDefaultDragGestureRecognizer(component, DnDConstants.ACTION_COPY, PlotLink.this::drag);
            }
        }

        @Override
        public void mouseMoved(MouseEvent event) {
            boolean linked = !plottableAt(event.getPoint()).isEmpty();
            component.setCursor(linked ? HAND : null);
            if (linked) {
                component.setToolTipText(tip(component.getToolTipText()));
            }
        }

        @Override
        public void mousePressed(MouseEvent event) {
            if (event.isPopupTrigger()) {
                showMenu(event.getPoint());
            }
        }

        @Override
        public void mouseReleased(MouseEvent event) {
            if (event.isPopupTrigger()) {
                showMenu(event.getPoint());
            } else if (SwingUtilities.isLeftMouseButton(event) && component.contains(event.getPoint())) {
                plot(parametersAt.apply(event.getPoint()), event.isControlDown() || event.isMetaDown());
            }
        }
    }

    /** Shows that the component has the focus. */
    private static final class Highlight extends FocusAdapter {
        private final JComponent component;
        private @Nullable Color before;

        Highlight(JComponent component) {
            this.component = component;
        }

        @Override
        public void focusGained(FocusEvent event) {
            before = component.getBackground();
            component.setBackground(DrawingColors.current().tint(0.25));
            component.setOpaque(true);
            component.repaint();
        }

        @Override
        public void focusLost(FocusEvent event) {
            component.setBackground(before);
            component.setOpaque(false);
            component.repaint();
        }
    }
}
