package majic.aibo;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.RoundRectangle2D;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.UIManager;

/** Draws the dog: on the left from above with its beams, nose up; on the right its head and neck from the side. */
final class DogDrawing extends JComponent {
    private static final long serialVersionUID = 1;

    /** The farthest the far sensor sees, which fills the height, mm. */
    private static final double VIEW_MM = 1500;

    private static final double DOG_LENGTH_MM = 270;
    private static final double DOG_WIDTH_MM = 140;
    private static final double REAR_MM = 120;
    private static final double HEAD_MM = 70;
    private static final int SIDE_LIMB = 40;

    private final transient Dog dog;

    DogDrawing(Dog dog) {
        this.dog = dog;
        setPreferredSize(new Dimension(420, 320));
        setMinimumSize(new Dimension(160, 120));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D pen = (Graphics2D) graphics.create();
        pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        paintFromAbove((Graphics2D) pen.create());
        paintFromTheSide((Graphics2D) pen.create());
        pen.dispose();
    }

    private void paintFromAbove(Graphics2D pen) {
        double scale = getHeight() / (VIEW_MM + 2 * DOG_LENGTH_MM);
        pen.translate(getWidth() / 4.0, getHeight() - DOG_LENGTH_MM * scale);
        pen.scale(scale, -scale);
        pen.setStroke(new BasicStroke((float) (1.5 / scale)));
        pen.setColor(color("Label.foreground", Color.GRAY));
        pen.draw(new RoundRectangle2D.Double(
                -DOG_WIDTH_MM / 2, -REAR_MM, DOG_WIDTH_MM, DOG_LENGTH_MM - HEAD_MM, 40, 40));
        dog.frontMm().ifPresent(mm -> drawNearest(pen, mm));
        pen.translate(0, Surroundings.HEAD_AHEAD_MM);
        drawBeam(pen, 0, dog.infraRed().chestMm());
        drawHead(pen);
        pen.dispose();
    }

    private void drawHead(Graphics2D pen) {
        double pan = dog.senses().number(Sensor.HEAD_PAN).orElse(0.0);
        drawBeam(pen, pan, dog.infraRed().headMm());
        pen.rotate(Math.toRadians(pan));
        pen.setColor(color("Label.foreground", Color.GRAY));
        pen.fill(new Ellipse2D.Double(-HEAD_MM / 2, -HEAD_MM / 2, HEAD_MM, HEAD_MM * 1.2));
    }

    private void drawBeam(Graphics2D pen, double panDeg, Optional<Double> mm) {
        AffineTransform before = pen.getTransform();
        pen.rotate(Math.toRadians(panDeg));
        double end = mm.orElse(VIEW_MM);
        pen.setColor(mm.isPresent() ? accent() : color("Label.disabledForeground", Color.LIGHT_GRAY));
        pen.draw(new Line2D.Double(0, 0, 0, end));
        if (mm.isPresent()) {
            pen.fill(new Ellipse2D.Double(-20, end - 20, 40, 40));
        }
        pen.setTransform(before);
    }

    /** The width that the dog needs, at what is nearest in it. */
    private static void drawNearest(Graphics2D pen, double mm) {
        double ahead = Surroundings.HULL_AHEAD_MM + mm;
        pen.setColor(accent());
        pen.draw(new Line2D.Double(-Surroundings.CORRIDOR_HALF_MM, ahead, Surroundings.CORRIDOR_HALF_MM, ahead));
    }

    private void paintFromTheSide(Graphics2D pen) {
        double neck = dog.senses().number(Sensor.NECK).orElse(0.0);
        double tilt = dog.senses().number(Sensor.HEAD_TILT).orElse(0.0);
        pen.translate(getWidth() * 0.8, getHeight() * 0.3);
        pen.setStroke(new BasicStroke(3));
        pen.setColor(color("Label.foreground", Color.GRAY));
        pen.draw(new RoundRectangle2D.Double(-2.5 * SIDE_LIMB, 0, 2.5 * SIDE_LIMB, SIDE_LIMB, 12, 12));
        pen.rotate(Math.toRadians(-neck));
        pen.draw(new Line2D.Double(0, 0, 0, -SIDE_LIMB));
        pen.translate(0, -SIDE_LIMB);
        pen.rotate(Math.toRadians(neck - tilt));
        pen.fill(new Ellipse2D.Double(-12, -14, SIDE_LIMB, 28));
        pen.dispose();
    }

    private static Color accent() {
        return color("Component.accentColor", new Color(0x2675BF));
    }

    private static Color color(String key, Color otherwise) {
        Color known = UIManager.getColor(key);
        return known == null ? otherwise : known;
    }
}
