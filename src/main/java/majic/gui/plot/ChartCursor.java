package majic.gui.plot;

import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.OptionalDouble;
import javax.swing.SwingUtilities;
import majic.gui.plot.PlotModel.Zoom;
import majic.gui.plot.data.Span;
import majic.panel.DrawingColors;
import org.jspecify.annotations.Nullable;

/**
 * The cursor of a chart: a line with the values under it, moved by mouse or keys. The wheel zooms the time around it,
 * with Shift the values; dragging zooms to a rectangle; a double click shows the newest readings again.
 */
final class ChartCursor {
    private static final double ZOOM_STEP = 1.25;

    /** Shorter drags are clicks; lower rectangles choose a time only. */
    private static final int LEAST_DRAG_PX = 6;

    private static final int LEAST_HEIGHT_PX = 24;

    private final PlotView view;
    private final PlotModel model;
    private @Nullable Point at;
    private @Nullable Point pressed;

    ChartCursor(PlotView view, PlotModel model) {
        this.view = view;
        this.model = model;
    }

    void install() {
        Mouse mouse = new Mouse();
        view.addMouseListener(mouse);
        view.addMouseMotionListener(mouse);
        view.addMouseWheelListener(mouse);
    }

    /** Moves the cursor by keys; without cursor begins in the middle. */
    void move(int pixels) {
        PaintedChart chart = view.chart();
        if (chart != null) {
            Rectangle2D plot = chart.plot();
            Point last = at;
            double x = last == null ? plot.getCenterX() : last.x + pixels;
            at = new Point(
                    (int) Math.max(plot.getX(), Math.min(plot.getMaxX(), x)),
                    last == null ? (int) plot.getCenterY() : last.y);
            chartChanged();
            view.repaint();
        }
    }

    /** Zooms the time around the cursor; around the right end without cursor. */
    void zoomTime(int steps) {
        PaintedChart chart = view.chart();
        if (chart != null) {
            Span time = model.time();
            OptionalDouble cursor = timeAtCursor(chart);
            zoom(time.scaled(Math.pow(ZOOM_STEP, steps), cursor.orElse(time.to())), fixedAxes());
        }
    }

    private void zoomValues(PaintedChart chart, int y, int steps) {
        double share = (chart.plot().getMaxY() - y) / chart.plot().getHeight();
        double factor = Math.pow(ZOOM_STEP, steps);
        List<ValueAxis> axes = chart.axes().stream()
                .map(axis -> axis.with(axis.range()
                        .scaled(
                                factor,
                                axis.range().from() + share * axis.range().length())))
                .toList();
        zoom(model.time(), axes);
    }

    private List<ValueAxis> fixedAxes() {
        Zoom zoom = model.zoom();
        return zoom == null ? List.of() : zoom.axes();
    }

    private void zoom(Span time, List<ValueAxis> axes) {
        model.zoom(new Zoom(time, axes));
    }

    private OptionalDouble timeAtCursor(PaintedChart chart) {
        Point cursor = at;
        return cursor == null || !isInPlot(chart, cursor)
                ? OptionalDouble.empty()
                : OptionalDouble.of(chart.timeAt(cursor.x));
    }

    private static boolean isInPlot(PaintedChart chart, Point point) {
        return point.x >= chart.plot().getX() && point.x <= chart.plot().getMaxX();
    }

    /** Adapts the accessible description to the values under the cursor. */
    void chartChanged() {
        PaintedChart chart = view.chart();
        if (chart != null && view.isFocusOwner()) {
            OptionalDouble time = timeAtCursor(chart);
            String values = time.isPresent() ? String.join(", ", CursorDrawing.lines(chart, time.getAsDouble())) : "";
            view.getAccessibleContext().setAccessibleDescription(values);
        }
    }

    void paint(Graphics2D pen, PaintedChart chart) {
        Rectangle2D rectangle = dragged(chart);
        if (rectangle != null) {
            DrawingColors colors = DrawingColors.current();
            pen.setColor(colors.wash(0.15));
            pen.fill(rectangle);
            pen.setColor(colors.accent());
            pen.draw(rectangle);
        } else {
            timeAtCursor(chart).ifPresent(time -> CursorDrawing.paint(pen, chart, time));
        }
    }

    /** Returns the rectangle that is dragged, of full height if it is too low to choose values. */
    private @Nullable Rectangle2D dragged(PaintedChart chart) {
        Point from = pressed;
        Point to = at;
        if (from == null || to == null || Math.abs(from.x - to.x) < LEAST_DRAG_PX) {
            return null;
        }
        Rectangle2D rectangle = new Rectangle(from);
        rectangle.add(to);
        if (rectangle.getHeight() < LEAST_HEIGHT_PX) {
            rectangle.add(from.x, chart.plot().getY());
            rectangle.add(from.x, chart.plot().getMaxY());
        }
        return rectangle.createIntersection(chart.plot());
    }

    private void zoomTo(PaintedChart chart, Rectangle2D rectangle) {
        Rectangle2D plot = chart.plot();
        Span time = new Span(chart.timeAt(rectangle.getX()), chart.timeAt(rectangle.getMaxX()));
        double low = (plot.getMaxY() - rectangle.getMaxY()) / plot.getHeight();
        double high = (plot.getMaxY() - rectangle.getY()) / plot.getHeight();
        boolean wholeHeight = low <= 0 && high >= 1;
        List<ValueAxis> axes = chart.axes().stream()
                .map(axis -> axis.with(axis.range().part(low, high)))
                .toList();
        zoom(time, wholeHeight ? fixedAxes() : axes);
    }

    private final class Mouse extends MouseAdapter {
        @Override
        public void mousePressed(MouseEvent event) {
            view.requestFocusInWindow();
            if (SwingUtilities.isLeftMouseButton(event)) {
                pressed = event.getPoint();
            }
        }

        @Override
        public void mouseReleased(MouseEvent event) {
            at = event.getPoint();
            PaintedChart chart = view.chart();
            Rectangle2D rectangle = chart == null ? null : dragged(chart);
            pressed = null;
            if (chart != null && rectangle != null && !rectangle.isEmpty()) {
                zoomTo(chart, rectangle);
            }
            view.repaint();
        }

        @Override
        public void mouseClicked(MouseEvent event) {
            if (event.getClickCount() == 2) {
                model.zoom(null);
            }
        }

        @Override
        public void mouseMoved(MouseEvent event) {
            at = event.getPoint();
            view.repaint();
        }

        @Override
        public void mouseDragged(MouseEvent event) {
            mouseMoved(event);
        }

        @Override
        public void mouseExited(MouseEvent event) {
            at = null;
            view.repaint();
        }

        @Override
        public void mouseWheelMoved(MouseWheelEvent event) {
            at = event.getPoint();
            PaintedChart chart = view.chart();
            if (event.isShiftDown() && chart != null) {
                zoomValues(chart, event.getY(), event.getWheelRotation());
            } else {
                zoomTime(event.getWheelRotation());
            }
        }
    }
}
