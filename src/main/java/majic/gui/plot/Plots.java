package majic.gui.plot;

import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.datatransfer.Transferable;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.JFrame;
import majic.environment.Settings;
import majic.gui.kit.ClearOfStop;
import majic.gui.plot.data.PlotSource;
import majic.gui.plot.data.Quantity;
import org.jspecify.annotations.Nullable;

/** The plots of one source, each in a window of its own. Must be used on the event dispatch thread. */
public final class Plots implements AutoCloseable {
    private static final int OFFSET_PX = 28;
    private static final int MOST_OFFSETS = 8;
    private static final int MOST_WINDOWS = 20;

    private final Window owner;
    private final Settings settings;
    private final Supplier<PlotSource> sources;
    private final Supplier<? extends JComponent> stopButtons;
    private final List<PlotWindow> windows = new ArrayList<>();
    private @Nullable PlotSource source;

    /**
     * Creates plots without windows.
     *
     * @param owner the window near which the plots are opened, and whose icons they have
     * @param settings keep the folder of the last file, and the computed curves
     * @param sources makes the source of the readings, at the first plot
     * @param stopButtons makes the STOP button of each window
     */
    public Plots(
            Window owner, Settings settings, Supplier<PlotSource> sources, Supplier<? extends JComponent> stopButtons) {
        this.owner = owner;
        this.settings = settings;
        this.sources = sources;
        this.stopButtons = stopButtons;
    }

    /**
     * Shows curves of parameters of a robot.
     *
     * @param robot the robot's number
     * @param parameters their names; nothing happens for those that the robot does not have
     * @param add whether the curves are added to the window that was used last, if there is one
     */
    public void plot(int robot, List<String> parameters, boolean add) {
        List<Quantity> quantities = readings(robot, parameters).quantities();
        windows.removeIf(window -> !window.isDisplayable());
        if (!quantities.isEmpty()) {
            PlotWindow window = add && !windows.isEmpty() ? windows.get(windows.size() - 1) : open(true, quantities);
            window.model().add(quantities);
            window.toFront();
        }
    }

    /**
     * Shows curves of parameters of robots in a window of their own, which does not take the focus; a window that shows
     * just these comes to the front. If very many windows are open, the one that was used last gets the curves.
     *
     * @param robots their numbers
     * @param parameters their names; those that a robot does not have are left out
     * @return false if there is nothing to show yet
     */
    public boolean plotAlone(List<Integer> robots, List<String> parameters) {
        List<Quantity> quantities = robots.stream()
                .flatMap(robot -> readings(robot, parameters).quantities().stream())
                .toList();
        if (quantities.isEmpty()) {
            return false;
        }
        windows.removeIf(window -> !window.isDisplayable());
        PlotWindow window = windows.stream()
                .filter(open -> open.model().shows(quantities))
                .findFirst()
                .orElseGet(() ->
                        windows.size() < MOST_WINDOWS ? open(false, quantities) : windows.get(windows.size() - 1));
        window.model().add(quantities);
        window.toFront();
        return true;
    }

    /** Returns parameters of a robot for dragging them onto one of these plots, which come to the front. */
    public Transferable dragged(int robot, List<String> parameters) {
        windows.forEach(Window::toFront);
        return readings(robot, parameters);
    }

    private DraggedReadings readings(int robot, List<String> parameters) {
        return new DraggedReadings(source(), robot, List.copyOf(parameters));
    }

    /** Opens an empty plot and the dialog that adds curves to it. */
    public void openEmpty() {
        open(true, List.of()).addCurves();
    }

    private PlotSource source() {
        PlotSource made = source;
        if (made == null) {
            made = sources.get();
            source = made;
        }
        return made;
    }

    private PlotWindow open(boolean takesFocus, List<Quantity> quantities) {
        windows.removeIf(window -> !window.isDisplayable());
        PlotWindow window = new PlotWindow(new PlotModel(source()), settings, stopButtons.get());
        window.setIconImages(owner.getIconImages());
        place(window);
        windows.add(window);
        window.addWindowListener(new LastUsed(window));
        window.setAutoRequestFocus(takesFocus);
        window.model().add(quantities);
        window.restoreComputed();
        window.setVisible(true);
        return window;
    }

    /** Places a window beside those before it, within the screen. */
    private void place(Window window) {
        int offset = OFFSET_PX * (windows.size() % MOST_OFFSETS + 1);
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        int right = screen.x + screen.width - window.getWidth();
        int bottom = screen.y + screen.height - window.getHeight();
        window.setLocation(
                Math.max(screen.x, Math.min(owner.getX() + offset, right)),
                Math.max(screen.y, Math.min(owner.getY() + offset, bottom)));
        ClearOfStop.place(window, owner);
    }

    /**
     * Builds a plot of the first robot, if there is one, without showing it.
     *
     * @param paint paints the window
     */
    public void rehearse(Consumer<JFrame> paint) {
        PlotWindow window = new PlotWindow(new PlotModel(source()), settings, stopButtons.get());
        window.model().add(readings(1, List.of("x", "heading")).quantities());
        place(window);
        paint.accept(window);
        window.dispose();
    }

    /** Closes all windows. */
    @Override
    public void close() {
        windows.forEach(Window::dispose);
        windows.clear();
    }

    /** Moves a window that becomes active to the end of the list. */
    private final class LastUsed extends WindowAdapter {
        private final PlotWindow window;

        LastUsed(PlotWindow window) {
            this.window = window;
        }

        @Override
        public void windowActivated(WindowEvent event) {
            if (windows.remove(window)) {
                windows.add(window);
            }
        }
    }
}
