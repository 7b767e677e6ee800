package majic.panel.map;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import majic.bot.Pose;
import majic.panel.Ink;

/**
 * What the floors of all robots share: where the robot started, the way it came, and how much of the floor is worth seeing.
 * {@link #hear} is for the driver's threads, everything else for the event dispatch thread.
 */
public abstract class WayContent implements RobotContent {
    private final Trail trail = new Trail();
    private final WayDrawing way;
    private final Reach reach;

    /**
     * How much floor around the robot is seen while the map follows it.
     *
     * @param pxPerMm at which the robot is drawn at least, as long as that leaves the least reach around it
     * @param leastMm to the nearest edge of the map
     * @param mostMm to the nearest edge of the map
     * @param marginMm around everything when everything is shown
     */
    public record Reach(double pxPerMm, double leastMm, double mostMm, double marginMm) {}

    /**
     * A floor that nobody has been on.
     *
     * @param reach how much of it is seen
     * @param measured whether the robot measures its way; else it is drawn as an estimate
     */
    protected WayContent(Reach reach, boolean measured) {
        this.reach = reach;
        this.way = measured ? WayDrawing.measured(trail) : WayDrawing.estimated(trail);
    }

    /**
     * Remembers where the robot is.
     *
     * @param now on the floor
     */
    public final void hear(Pose now) {
        trail.add(now);
    }

    @Override
    public final Rectangle2D extent() {
        Rectangle2D extent = new Rectangle2D.Double(pose().xMm(), pose().yMm(), 0, 0);
        extent.add(0, 0);
        trail.extend(extent);
        extend(extent);
        return new Rectangle2D.Double(
                extent.getX() - reach.marginMm(),
                extent.getY() - reach.marginMm(),
                extent.getWidth() + 2 * reach.marginMm(),
                extent.getHeight() + 2 * reach.marginMm());
    }

    /**
     * Makes a piece of floor so large that it holds what else is to be seen.
     *
     * @param extent mm; holds the start, the robot and its way
     */
    protected void extend(Rectangle2D extent) {}

    @Override
    public final double nearPxPerMm(int sidePx) {
        double reachMm = Math.max(reach.leastMm(), Math.min(reach.mostMm(), sidePx / 2.0 / reach.pxPerMm()));
        return sidePx / 2.0 / reachMm;
    }

    @Override
    public void clear() {
        trail.clear();
    }

    /**
     * Paints the way.
     *
     * @param pen in pixels
     * @param view from the floor to the pixels
     * @param ink what it is painted with
     */
    protected final void paintWay(Graphics2D pen, MapView view, Ink ink) {
        way.paint(pen, view, ink);
    }
}
