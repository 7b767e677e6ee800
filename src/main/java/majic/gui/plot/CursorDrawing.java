package majic.gui.plot;

import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.ArrayList;
import java.util.List;
import majic.gui.plot.data.Quantity;

/** Paints the line of the cursor with the values under it. */
final class CursorDrawing {
    private static final int INSET = 6;
    private static final int DOT = 7;

    /** How near a mark is to the cursor for its text to be shown. */
    private static final double NEAR_PX = 5;

    private CursorDrawing() {}

    static void paint(Graphics2D pen, PaintedChart chart, double time) {
        ChartLook look = chart.job().look();
        Rectangle2D plot = chart.plot();
        double x = chart.xOf(time);
        pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        pen.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        pen.setFont(look.font());
        pen.setColor(look.text());
        pen.draw(new Line2D.Double(x, plot.getY(), x, plot.getMaxY()));
        chart.job().curves().forEach(curve -> paintDot(pen, chart, curve, time));
        paintBox(pen, chart, x, lines(chart, time));
    }

    private static void paintDot(Graphics2D pen, PaintedChart chart, Curve curve, double time) {
        double value = curve.points().at(time);
        double y = chart.yOf(curve, value);
        if (!Double.isNaN(y) && y >= chart.plot().getY() && y <= chart.plot().getMaxY()) {
            pen.setColor(curve.style().color());
            pen.fill(new Ellipse2D.Double(chart.xOf(time) - DOT / 2.0, y - DOT / 2.0, DOT, DOT));
        }
    }

    /** Returns the texts at a time: the time, the values, and the marks nearby. */
    static List<String> lines(PaintedChart chart, double time) {
        List<String> lines = new ArrayList<>();
        lines.add(ClockText.of(time, 0));
        for (Curve curve : chart.job().curves()) {
            Quantity quantity = curve.quantity();
            lines.add(quantity.robot() + " " + quantity.name() + "   "
                    + Curve.text(quantity, curve.points().at(time)));
        }
        double near = NEAR_PX / chart.plot().getWidth() * chart.job().time().length();
        chart.job().marks().stream()
                .filter(mark -> Math.abs(mark.seconds() - time) < near)
                .map(MarksDrawing::text)
                .forEach(lines::add);
        return lines;
    }

    private static void paintBox(Graphics2D pen, PaintedChart chart, double x, List<String> lines) {
        FontMetrics metrics = pen.getFontMetrics();
        int textWidth = lines.stream().mapToInt(metrics::stringWidth).max().orElse(0);
        double width = textWidth + 2.0 * INSET;
        double height = lines.size() * metrics.getHeight() + INSET;
        boolean fitsRight = x + INSET + width < chart.plot().getMaxX();
        double left = fitsRight ? x + INSET : x - INSET - width;
        double top = Math.max(chart.plot().getY() + INSET, chart.plot().getMaxY() - height - INSET);
        RoundRectangle2D box = new RoundRectangle2D.Double(left, top, width, height, INSET, INSET);
        pen.setColor(chart.job().look().paper());
        pen.fill(box);
        pen.setColor(chart.job().look().frame());
        pen.draw(box);
        double base = top + INSET / 2.0 + metrics.getAscent();
        for (int line = 0; line < lines.size(); line++) {
            pen.setColor(color(chart, line));
            pen.drawString(lines.get(line), (float) (left + INSET), (float) (base + line * metrics.getHeight()));
        }
    }

    /** Returns the colour of a line: the curve's for a value. */
    private static Color color(PaintedChart chart, int line) {
        List<Curve> curves = chart.job().curves();
        boolean isValue = line > 0 && line <= curves.size();
        return isValue
                ? curves.get(line - 1).style().color()
                : chart.job().look().text();
    }
}
