package majic.gui.plot;

import java.awt.BasicStroke;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import majic.gui.plot.data.PlotMark;
import majic.panel.DrawingColors;

/**
 * Paints the marks of a chart: a dashed line where a command began, a dotted one where it ended, with its text at the
 * top where there is room.
 */
final class MarksDrawing {
    private static final int ROWS = 3;
    private static final int GAP = 4;
    private static final int LONGEST_TEXT = 36;

    /** Opacity of the background of texts: the curves behind them remain visible. */
    private static final double BACKGROUND = 0.7;

    private static final BasicStroke BEGIN = dashed(5, 3);
    private static final BasicStroke END = dashed(1, 3);

    private final Graphics2D pen;
    private final PaintedChart chart;
    private final double[] freeFrom = new double[ROWS];

    private MarksDrawing(Graphics2D pen, PaintedChart chart) {
        this.pen = pen;
        this.chart = chart;
        Arrays.fill(freeFrom, chart.plot().getX());
    }

    private static BasicStroke dashed(float length, float gap) {
        return new BasicStroke(1, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL, 1, new float[] {length, gap}, 0);
    }

    /** Paints all marks of a chart. */
    static void paint(Graphics2D pen, PaintedChart chart) {
        pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        pen.setFont(chart.job().look().font());
        MarksDrawing drawing = new MarksDrawing(pen, chart);
        chart.job().marks().forEach(drawing::paint);
    }

    /** Returns the text of a mark, with a sign for its kind. */
    static String text(PlotMark mark) {
        String text =
                mark.text().length() > LONGEST_TEXT ? mark.text().substring(0, LONGEST_TEXT - 1) + "…" : mark.text();
        return (mark.end() ? "■ " : "▶ ") + text;
    }

    private void paint(PlotMark mark) {
        Rectangle2D plot = chart.plot();
        double x = chart.xOf(mark.seconds());
        pen.setColor(chart.job().look().frame());
        pen.setStroke(mark.end() ? END : BEGIN);
        pen.draw(new Line2D.Double(x, plot.getY(), x, plot.getMaxY()));
        FontMetrics metrics = pen.getFontMetrics();
        int width = metrics.stringWidth(text(mark));
        double left = Math.min(x + GAP, plot.getMaxX() - width - GAP);
        for (int row = 0; row < ROWS; row++) {
            if (left >= freeFrom[row]) {
                freeFrom[row] = left + width + 2 * GAP;
                paintText(text(mark), left, plot.getY() + GAP + row * metrics.getHeight(), width);
                return;
            }
        }
    }

    private void paintText(String text, double left, double top, int width) {
        FontMetrics metrics = pen.getFontMetrics();
        ChartLook look = chart.job().look();
        pen.setColor(DrawingColors.translucent(look.paper(), BACKGROUND));
        pen.fill(new Rectangle2D.Double(left - 2, top, width + 4, metrics.getHeight()));
        pen.setColor(look.text());
        pen.drawString(text, (float) left, (float) (top + metrics.getAscent()));
    }
}
