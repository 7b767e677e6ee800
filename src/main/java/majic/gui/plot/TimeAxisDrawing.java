package majic.gui.plot;

import java.awt.BasicStroke;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import majic.gui.plot.data.Span;
import majic.panel.DrawingColors;

/** Paints the times below a chart, and a line of the grid above each; XChart places its own at odd moments. */
final class TimeAxisDrawing {
    private static final double[] STEPS_S = {
        0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200
    };
    private static final int GAP = 14;
    private static final int TICK = 4;
    private static final double GRID_OPACITY = 0.12;

    private TimeAxisDrawing() {}

    /** Returns the height of the times, below the chart's own picture. */
    static int height(Graphics2D pen, ChartLook look) {
        return pen.getFontMetrics(look.font()).getHeight();
    }

    static void paint(Graphics2D pen, PaintedChart chart) {
        ChartLook look = chart.job().look();
        Span time = chart.job().time();
        Rectangle2D plot = chart.plot();
        pen.setFont(look.font());
        pen.setStroke(new BasicStroke(1));
        FontMetrics metrics = pen.getFontMetrics();
        double room = metrics.stringWidth(ClockText.of(time.to(), time.length())) + GAP;
        double step = step(room / plot.getWidth() * time.length());
        for (double tick = Math.ceil(time.from() / step); tick * step <= time.to(); tick++) {
            double x = chart.xOf(tick * step);
            pen.setColor(DrawingColors.translucent(look.text(), GRID_OPACITY));
            pen.draw(new Line2D.Double(x, plot.getY(), x, plot.getMaxY()));
            pen.setColor(look.frame());
            pen.draw(new Line2D.Double(x, plot.getMaxY(), x, plot.getMaxY() + TICK));
            String text = ClockText.of(tick * step, time.length());
            pen.setColor(look.text());
            pen.drawString(text, (float) (x - metrics.stringWidth(text) / 2.0), (float)
                    (plot.getMaxY() + TICK + metrics.getAscent()));
        }
    }

    /** Returns the smallest round step that leaves at least this time between two texts, seconds. */
    static double step(double leastS) {
        double longest = STEPS_S[STEPS_S.length - 1];
        return Arrays.stream(STEPS_S)
                .filter(step -> step >= leastS)
                .findFirst()
                .orElse(longest * Math.ceil(leastS / longest));
    }
}
