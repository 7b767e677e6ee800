package majic.panel.map;

import java.awt.BasicStroke;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Stroke;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import majic.panel.Ink;

/** The way a robot came, from where it started. For the event dispatch thread. */
public final class WayDrawing {
    private static final String START = "start";
    private static final double START_PX = 5;
    private static final double STEP_PX = 2;

    /** Thousands of round joins would take longer than all the rest. */
    private static final Stroke MEASURED = new BasicStroke(1.6f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL);

    private static final Stroke ESTIMATED =
            new BasicStroke(1.6f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL, 1, new float[] {6, 3}, 0);

    private final Trail trail;
    private final Stroke stroke;
    private final Path2D way = new Path2D.Double();

    private WayDrawing(Trail trail, Stroke stroke) {
        this.trail = trail;
        this.stroke = stroke;
    }

    /**
     * The way of a robot that measures it.
     *
     * @param trail what is drawn, as it is at each painting
     * @return drawn in one line
     */
    public static WayDrawing measured(Trail trail) {
        return new WayDrawing(trail, MEASURED);
    }

    /**
     * The way of a robot that cannot tell how far it went.
     *
     * @param trail what is drawn, as it is at each painting
     * @return drawn in dashes
     */
    public static WayDrawing estimated(Trail trail) {
        return new WayDrawing(trail, ESTIMATED);
    }

    /**
     * Paints the way.
     *
     * @param pen in pixels
     * @param view from the floor to the pixels
     * @param ink what it is painted with
     */
    public void paint(Graphics2D pen, MapView view, Ink ink) {
        trail.trace(way, STEP_PX / view.pxPerMm());
        pen.setColor(ink.grey(0.6));
        pen.setStroke(stroke);
        pen.draw(view.transform().createTransformedShape(way));
    }

    /**
     * Paints a mark where the way begins.
     *
     * @param pen in pixels
     * @param view from the floor to the pixels
     * @param ink what it is painted with
     */
    public static void paintStart(Graphics2D pen, MapView view, Ink ink) {
        Point2D start = view.pixel(0, 0);
        pen.setColor(ink.grey(0.85));
        pen.setStroke(Ink.stroke(1.5));
        pen.draw(new Ellipse2D.Double(start.getX() - START_PX, start.getY() - START_PX, 2 * START_PX, 2 * START_PX));
        pen.fill(new Ellipse2D.Double(start.getX() - 1.5, start.getY() - 1.5, 3, 3));
        FontMetrics metrics = pen.getFontMetrics();
        float left = (float) (start.getX() - metrics.stringWidth(START) / 2.0);
        pen.drawString(START, left, (float) (start.getY() + START_PX + metrics.getAscent()));
    }
}
