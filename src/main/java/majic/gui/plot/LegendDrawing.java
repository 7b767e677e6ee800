package majic.gui.plot;

import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.List;

/** Paints the names of the curves below a chart that is saved as a picture, in as many rows as needed. */
final class LegendDrawing {
    private static final int LINE = 26;
    private static final int GAP = 8;
    private static final int APART = 22;

    private final Graphics2D pen;
    private final ChartJob job;
    private final FontMetrics metrics;
    private final List<List<Curve>> rows = new ArrayList<>();

    LegendDrawing(Graphics2D pen, ChartJob job) {
        this.pen = pen;
        this.job = job;
        this.metrics = pen.getFontMetrics(job.look().font());
        if (job.legend()) {
            job.curves().forEach(this::place);
        }
    }

    private void place(Curve curve) {
        int last = rows.size() - 1;
        if (last >= 0 && width(rows.get(last)) + width(curve) <= job.width() - 2 * GAP) {
            rows.get(last).add(curve);
        } else {
            rows.add(new ArrayList<>(List.of(curve)));
        }
    }

    private int width(List<Curve> row) {
        return row.stream().mapToInt(this::width).sum();
    }

    private int width(Curve curve) {
        return LINE + GAP + metrics.stringWidth(curve.label()) + APART;
    }

    /** Returns the height needed; 0 if the picture has no legend. */
    int height() {
        return rows.isEmpty() ? 0 : rows.size() * metrics.getHeight() + GAP;
    }

    void paint() {
        pen.setFont(job.look().font());
        int top = job.height() - height();
        for (List<Curve> row : rows) {
            int left = (job.width() - width(row) + APART) / 2;
            for (Curve curve : row) {
                paint(curve, left, top);
                left += width(curve);
            }
            top += metrics.getHeight();
        }
    }

    private void paint(Curve curve, int left, int top) {
        double middle = top + metrics.getHeight() / 2.0;
        pen.setColor(curve.style().color(job.look().dark()));
        pen.setStroke(curve.style().stroke());
        pen.draw(new Line2D.Double(left, middle, left + (double) LINE, middle));
        pen.setColor(job.look().text());
        pen.drawString(curve.label(), left + LINE + GAP, top + metrics.getAscent());
    }
}
