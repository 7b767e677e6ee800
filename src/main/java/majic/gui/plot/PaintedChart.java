package majic.gui.plot;

import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import majic.gui.plot.data.Span;

/**
 * A picture of a chart, with what is where in it.
 *
 * @param image the picture
 * @param job what it shows
 * @param plot the area of the curves, in pixels of the user interface
 * @param axes the axes of values, left ones first
 */
record PaintedChart(BufferedImage image, ChartJob job, Rectangle2D plot, List<ValueAxis> axes) {

    /** Returns the time at a place, seconds. */
    double timeAt(double x) {
        Span time = job.time();
        return time.from() + (x - plot.getX()) / plot.getWidth() * time.length();
    }

    double xOf(double seconds) {
        Span time = job.time();
        return plot.getX() + (seconds - time.from()) / time.length() * plot.getWidth();
    }

    /** Returns the place of a value of a curve, from the top. */
    double yOf(Curve curve, double value) {
        Span range = ValueAxis.find(axes, curve.quantity()).orElseThrow().range();
        return plot.getMaxY() - (value - range.from()) / range.length() * plot.getHeight();
    }
}
