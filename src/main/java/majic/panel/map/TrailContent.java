package majic.panel.map;

import java.awt.BasicStroke;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Stroke;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import majic.bot.Pose;
import majic.panel.DrawingColors;
import majic.text.Texts;

/**
 * The part of the map that all robots share: the robot's start, its trail, and the visible area. {@link #poseReported}
 * may be called on the driver's threads, everything else on the event dispatch thread.
 */
public abstract class TrailContent implements RobotContent {
    private static final Texts TEXTS = Texts.of(TrailContent.class);

    private static final double STEP_PX = 2;

    /** A bevelled join: thousands of round joins would take longer to paint than everything else. */
    private static final Stroke MEASURED = new BasicStroke(1.6f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL);

    private static final Stroke ESTIMATED =
            new BasicStroke(1.6f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL, 1, new float[] {6, 3}, 0);

    private final Trail trail = new Trail();
    private final Stroke stroke;
    private final Path2D path = new Path2D.Double();
    private final Reach reach;

    /**
     * How much floor around the robot is visible while the map follows it.
     *
     * @param pxPerMm minimum scale of the robot, as long as that leaves the minimum distance around it
     * @param leastMm minimum distance to the nearest edge of the map
     * @param mostMm maximum distance to the nearest edge of the map
     * @param marginMm margin around everything when everything is shown
     */
    public record Reach(double pxPerMm, double leastMm, double mostMm, double marginMm) {}

    /**
     * Creates a floor without a trail.
     *
     * @param reach how much of it is visible
     * @param measured whether the robot measures its path; otherwise the trail is drawn as an estimate
     */
    protected TrailContent(Reach reach, boolean measured) {
        this.reach = reach;
        this.stroke = measured ? MEASURED : ESTIMATED;
    }

    /**
     * Records the robot's pose.
     *
     * @param now on the floor
     */
    public final void poseReported(Pose now) {
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
     * Enlarges an area of the floor so that it contains the further content.
     *
     * @param extent mm; contains the start, the robot and its trail
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
     * Paints the trail.
     *
     * @param pen in pixels
     * @param view from the floor to the pixels
     * @param colors the colours to use
     */
    protected final void paintTrail(Graphics2D pen, MapView view, DrawingColors colors) {
        trail.trace(path, STEP_PX / view.pxPerMm());
        pen.setColor(colors.grey(0.6));
        pen.setStroke(stroke);
        pen.draw(view.transform().createTransformedShape(path));
    }

    /**
     * Paints that the robot has reported nothing yet.
     *
     * @param pen in pixels
     * @param view from the floor to the pixels
     */
    protected static void paintNoReading(Graphics2D pen, MapView view) {
        String text = TEXTS.get("noReading");
        FontMetrics metrics = pen.getFontMetrics();
        pen.setColor(DrawingColors.current().faint());
        pen.drawString(text, (view.width() - metrics.stringWidth(text)) / 2, view.height() / 2);
    }

    /**
     * Makes a pen for the robot's own frame.
     *
     * @param pen in pixels
     * @param view from the floor to the pixels
     * @param pose the robot's, on the floor
     * @return a copy: x ahead, y to the left, mm; to be disposed of
     */
    protected static Graphics2D inRobotFrame(Graphics2D pen, MapView view, Pose pose) {
        Graphics2D robot = (Graphics2D) pen.create();
        robot.transform(view.transform());
        robot.translate(pose.xMm(), pose.yMm());
        robot.rotate(Math.toRadians(pose.headingDeg()));
        return robot;
    }
}
