package majic.panel.map;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.Stroke;
import java.awt.geom.Path2D;
import majic.panel.DrawingColors;

/** Draws the trail of a robot, from its start. Must be used on the event dispatch thread. */
public final class TrailDrawing {
    private static final double STEP_PX = 2;

    /** A bevelled join: thousands of round joins would take longer to paint than everything else. */
    private static final Stroke MEASURED = new BasicStroke(1.6f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL);

    private static final Stroke ESTIMATED =
            new BasicStroke(1.6f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL, 1, new float[] {6, 3}, 0);

    private final Trail trail;
    private final Stroke stroke;
    private final Path2D path = new Path2D.Double();

    private TrailDrawing(Trail trail, Stroke stroke) {
        this.trail = trail;
        this.stroke = stroke;
    }

    /**
     * Creates a drawing of the trail of a robot that measures its path.
     *
     * @param trail the trail, read at each painting
     * @return a solid line
     */
    public static TrailDrawing measured(Trail trail) {
        return new TrailDrawing(trail, MEASURED);
    }

    /**
     * Creates a drawing of the trail of a robot that cannot measure how far it moved.
     *
     * @param trail the trail, read at each painting
     * @return a dashed line
     */
    public static TrailDrawing estimated(Trail trail) {
        return new TrailDrawing(trail, ESTIMATED);
    }

    /**
     * Paints the trail.
     *
     * @param pen in pixels
     * @param view from the floor to the pixels
     * @param colors the colours to use
     */
    public void paint(Graphics2D pen, MapView view, DrawingColors colors) {
        trail.trace(path, STEP_PX / view.pxPerMm());
        pen.setColor(colors.grey(0.6));
        pen.setStroke(stroke);
        pen.draw(view.transform().createTransformedShape(path));
    }
}
