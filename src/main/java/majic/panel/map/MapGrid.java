package majic.panel.map;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.RoundRectangle2D;
import majic.panel.DrawingColors;

/** Draws grid lines on a floor at round distances, and a scale bar as long as their distance. */
final class MapGrid {
    private static final float WANTED_PX = 90;
    private static final int INSET = 10;
    private static final int TICK = 4;

    private final Graphics2D pen;
    private final MapView view;
    private final DrawingColors colors;
    private final double stepMm;

    MapGrid(Graphics2D pen, MapView view, DrawingColors colors) {
        this.pen = pen;
        this.view = view;
        this.colors = colors;
        this.stepMm = Lengths.round(UIScale.scale(WANTED_PX) / view.pxPerMm());
    }

    /** Paints all visible lines, at any rotation of the floor; lines parallel to the axes of the screen are sharp. */
    void paintLines() {
        double reach = Math.hypot(view.width(), view.height()) / 2 / view.pxPerMm();
        pen.setColor(colors.grey(0.13));
        pen.setStroke(sharp());
        Object smooth = pen.getRenderingHint(RenderingHints.KEY_ANTIALIASING);
        if (view.upDeg() == MapView.Y_UP) {
            pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_OFF);
        }
        for (double x = first(view.xMm() - reach); x <= view.xMm() + reach; x += stepMm) {
            line(x, view.yMm() - reach, x, view.yMm() + reach);
        }
        for (double y = first(view.yMm() - reach); y <= view.yMm() + reach; y += stepMm) {
            line(view.xMm() - reach, y, view.xMm() + reach, y);
        }
        pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, smooth);
    }

    /** Returns a stroke of whole pixels of the screen, also where the system scales windows by 1.25 or 1.5. */
    private BasicStroke sharp() {
        double scale = Math.max(1, Math.abs(pen.getTransform().getScaleX()));
        return new BasicStroke((float) (Math.floor(scale) / scale));
    }

    private double first(double fromMm) {
        return Math.ceil(fromMm / stepMm) * stepMm;
    }

    private void line(double x1, double y1, double x2, double y2) {
        Point2D from = view.pixel(x1, y1);
        Point2D to = view.pixel(x2, y2);
        pen.draw(new Line2D.Double(from, to));
    }

    /**
     * Paints the scale bar at the lower left, on a margin of the floor's colour so that it is readable on any
     * background.
     */
    void paintScale(Color floor) {
        String text = Lengths.text(stepMm);
        FontMetrics metrics = pen.getFontMetrics();
        double length = stepMm * view.pxPerMm();
        double y = view.height() - INSET;
        double width = Math.max(length, metrics.stringWidth(text)) + 2 * TICK;
        double height = metrics.getAscent() + 3 * TICK;
        pen.setColor(DrawingColors.translucent(floor, 0.75));
        pen.fill(new RoundRectangle2D.Double(INSET - TICK, y + TICK + 1 - height, width, height, 6, 6));
        pen.setColor(colors.faint());
        pen.setStroke(DrawingColors.stroke(1.5));
        pen.draw(new Line2D.Double(INSET, y, INSET + length, y));
        pen.draw(new Line2D.Double(INSET, y - TICK, INSET, y + TICK));
        pen.draw(new Line2D.Double(INSET + length, y - TICK, INSET + length, y + TICK));
        pen.drawString(text, INSET + TICK, (float) y - TICK - 1);
    }
}
