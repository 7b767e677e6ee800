package majic.panel;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import javax.swing.JPanel;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * An artificial horizon, as in an aircraft: the line stays level while the robot tilts; the mark in the middle is the
 * robot, seen from behind. Must be used on the event dispatch thread.
 */
public final class Horizon extends JPanel {
    private static final long serialVersionUID = 1;

    /** Tilt in degrees between the middle and the rim of the disc, unless set otherwise. */
    private static final double HALF_VIEW_DEG = 60;

    /** A change by this part of the view moves nothing by more than half a pixel. */
    private static final double UNSEEN = 1 / 60.0;

    /** Lines of the ladder between the middle and the rim. */
    private static final int RUNGS = 3;

    private static final int LAST_RUNG = 4;
    private static final double GROUND = 0.4;
    private static final Texts TEXTS = Texts.of(Horizon.class);

    private final double halfViewDeg;
    private transient @Nullable Tilt tilt;

    /**
     * The tilt of a robot.
     *
     * @param pitchDeg nose up positive, −90 to 90
     * @param rollDeg right side down positive, −180 to 180
     */
    public record Tilt(double pitchDeg, double rollDeg) {}

    /**
     * Creates a disc that shows nothing yet.
     *
     * @param diameter preferred, pixels at the normal font size
     */
    public Horizon(int diameter) {
        this(diameter, HALF_VIEW_DEG);
    }

    /**
     * Creates a disc that shows nothing yet.
     *
     * @param diameter preferred, pixels at the normal font size
     * @param halfViewDeg tilt between the middle and the rim, degrees, above 0
     */
    public Horizon(int diameter, double halfViewDeg) {
        this.halfViewDeg = halfViewDeg;
        setOpaque(false);
        setName("horizon");
        setPreferredSize(new Dimension(UIScale.scale(diameter), UIScale.scale(diameter)));
    }

    /**
     * Shows the tilt of the robot.
     *
     * @param newTilt null when it is not known
     */
    public void show(@Nullable Tilt newTilt) {
        if (!looksDifferent(newTilt)) {
            return;
        }
        tilt = newTilt;
        String words = newTilt == null
                ? TEXTS.get("horizon.none")
                : TEXTS.get("horizon", Math.round(newTilt.pitchDeg()), Math.round(newTilt.rollDeg()));
        setToolTipText(words);
        getAccessibleContext().setAccessibleName(words);
        repaint();
    }

    /** Compares with what is shown, so that small changes add up until they are seen. */
    private boolean looksDifferent(@Nullable Tilt newTilt) {
        Tilt shown = tilt;
        return shown == null
                || newTilt == null
                || Math.abs(newTilt.pitchDeg() - shown.pitchDeg()) > UNSEEN * halfViewDeg
                || Math.abs(newTilt.rollDeg() - shown.rollDeg()) > UNSEEN * halfViewDeg;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D pen = (Graphics2D) graphics.create();
        DrawingColors.prepare(pen);
        DrawingColors colors =
                isEnabled() ? DrawingColors.current() : DrawingColors.current().faded();
        double radius = Math.min(getWidth(), getHeight()) / 2.0 - 1.5;
        pen.translate(getWidth() / 2.0, getHeight() / 2.0);
        Shape disc = new Ellipse2D.Double(-radius, -radius, 2 * radius, 2 * radius);
        pen.setColor(colors.tint(0.12));
        pen.fill(disc);
        Tilt shown = tilt;
        if (shown != null) {
            Graphics2D world = (Graphics2D) pen.create();
            world.clip(disc);
            paintWorld(world, colors, radius, shown);
            world.dispose();
        }
        paintRobot(pen, colors, radius);
        pen.setColor(colors.grey(0.7));
        pen.setStroke(DrawingColors.stroke(1.5));
        pen.draw(disc);
        pen.dispose();
    }

    private void paintWorld(Graphics2D pen, DrawingColors colors, double radius, Tilt tilt) {
        double pxPerDeg = radius / halfViewDeg;
        pen.rotate(-Math.toRadians(tilt.rollDeg()));
        pen.translate(0, tilt.pitchDeg() * pxPerDeg);
        pen.setColor(colors.grey(GROUND));
        pen.fill(new Rectangle2D.Double(-4 * radius, 0, 8 * radius, 8 * radius));
        pen.setColor(colors.line());
        pen.setStroke(DrawingColors.stroke(1));
        pen.draw(new Line2D.Double(-4 * radius, 0, 4 * radius, 0));
        pen.setStroke(DrawingColors.stroke(0.8));
        for (int rung = -LAST_RUNG; rung <= LAST_RUNG; rung++) {
            double half = rung == 0 ? 0 : 0.22 * radius;
            double y = rung * radius / RUNGS;
            pen.draw(new Line2D.Double(-half, y, half, y));
        }
    }

    /** Draws the robot from behind: wings and a nose. */
    private static void paintRobot(Graphics2D pen, DrawingColors colors, double radius) {
        Path2D wings = new Path2D.Double();
        wings.moveTo(-0.62 * radius, 0);
        wings.lineTo(-0.25 * radius, 0);
        wings.lineTo(0, 0.2 * radius);
        wings.lineTo(0.25 * radius, 0);
        wings.lineTo(0.62 * radius, 0);
        pen.setColor(colors.paper());
        pen.setStroke(new BasicStroke(4.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        pen.draw(wings);
        pen.setColor(colors.accent());
        pen.setStroke(DrawingColors.stroke(2.2));
        pen.draw(wings);
    }
}
