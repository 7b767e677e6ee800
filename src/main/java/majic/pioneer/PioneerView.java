package majic.pioneer;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Arc2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import javax.swing.JComponent;
import javax.swing.UIManager;
import org.jspecify.annotations.Nullable;

/** A Pioneer from above, looking up, to scale, with its sonar cones and echoes. For the event thread. */
final class PioneerView extends JComponent {
    private static final long serialVersionUID = 1;

    /** From the robot to the edge of the view, mm. */
    private static final double REACH_MM = 2500;

    private static final double RING_MM = 1000;
    private static final double CONE_DEG = 30;
    private static final double ECHO_MM = 70;
    private static final int CONE_ALPHA = 40;

    private transient @Nullable Model model;
    private transient @Nullable PioneerState state;

    PioneerView() {
        setPreferredSize(new Dimension(360, 360));
        setMinimumSize(new Dimension(160, 160));
    }

    void show(Model newModel, PioneerState newState) {
        model = newModel;
        state = newState;
        repaint();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Model shown = model;
        PioneerState now = state;
        if (shown == null || now == null) {
            return;
        }
        Graphics2D canvas = (Graphics2D) graphics.create();
        canvas.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        canvas.transform(robotFrame());
        canvas.setStroke(new BasicStroke((float) (1.5 * 2 * REACH_MM / side())));
        paintRings(canvas);
        shown.discs().forEach(disc -> paintCone(canvas, disc, now.sonar()));
        paintRobot(canvas, shown.hull());
        canvas.dispose();
    }

    /** The robot's own axes: x up, y to the left, in mm, the robot in the middle. */
    private AffineTransform robotFrame() {
        AffineTransform frame = AffineTransform.getTranslateInstance(getWidth() / 2.0, getHeight() / 2.0);
        double scale = side() / (2 * REACH_MM);
        frame.concatenate(new AffineTransform(0, -scale, -scale, 0, 0, 0));
        return frame;
    }

    private double side() {
        return Math.max(1, Math.min(getWidth(), getHeight()));
    }

    private void paintRings(Graphics2D canvas) {
        canvas.setColor(color("Component.borderColor", Color.GRAY));
        for (double radius = RING_MM; radius <= REACH_MM; radius += RING_MM) {
            canvas.draw(circle(0, 0, radius));
        }
    }

    private void paintCone(Graphics2D canvas, SonarDisc disc, SonarScan scan) {
        if (!scan.hasHeard(disc.number())) {
            return;
        }
        int range = scan.rangeMm(disc.number());
        Color accent = color("Component.accentColor", Color.BLUE);
        canvas.setColor(new Color(accent.getRed(), accent.getGreen(), accent.getBlue(), CONE_ALPHA));
        canvas.fill(cone(disc, Math.min(range, 2 * REACH_MM)));
        if (range < SonarScan.NOTHING_MM) {
            canvas.setColor(color("Label.foreground", Color.BLACK));
            canvas.fill(circle(disc.echoX(range), disc.echoY(range), ECHO_MM / 2));
        }
    }

    /** Arc2D counts angles clockwise in these axes. */
    private static Arc2D cone(SonarDisc disc, double range) {
        double start = -disc.axisDeg() - CONE_DEG / 2;
        return new Arc2D.Double(
                disc.xMm() - range, disc.yMm() - range, 2 * range, 2 * range, start, CONE_DEG, Arc2D.PIE);
    }

    private void paintRobot(Graphics2D canvas, Hull hull) {
        Rectangle2D body = new Rectangle2D.Double(
                -hull.rearMm(), -hull.halfWidthMm(), hull.frontMm() + hull.rearMm(), 2 * hull.halfWidthMm());
        canvas.setColor(color("Panel.background", Color.WHITE));
        canvas.fill(body);
        canvas.setColor(color("Label.foreground", Color.BLACK));
        canvas.draw(body);
        canvas.draw(new Line2D.Double(0, 0, hull.frontMm(), 0));
    }

    private static Ellipse2D circle(double x, double y, double radius) {
        return new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius);
    }

    private static Color color(String key, Color otherwise) {
        Color color = UIManager.getColor(key);
        return color == null ? otherwise : color;
    }
}
