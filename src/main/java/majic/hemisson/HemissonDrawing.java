package majic.hemisson;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import javax.swing.JComponent;
import javax.swing.UIManager;

/**
 * The robot from above, its front upward: eight bars that grow with nearness, with their figures, lamps and wheels. Drawn
 * in millimetres of the robot's own frame, in the colours of the present look.
 */
final class HemissonDrawing extends JComponent {
    private static final long serialVersionUID = 1;

    private static final double SHOWN_MM = 130;
    private static final double BAR_MM = 40;
    private static final double BAR_WIDTH_MM = 12;
    private static final double FIGURE_MM = 14;
    private static final double FULL = 255;

    /** Where a bar begins and points: x, y in mm, direction in degrees. The ground's two stand inside, side by side. */
    private static final double[][] BARS = {
        {62, 0, 0}, {52, -34, -38}, {52, 34, 38}, {10, -62, -90}, {10, 62, 90}, {-66, 0, 180}, {0, -12, 0}, {0, 12, 0},
    };

    private transient HemissonView view;

    HemissonDrawing(HemissonView view) {
        this.view = view;
        setPreferredSize(new Dimension(360, 360));
        setToolTipText("infra-red proximity, 0 nothing to 255 near");
    }

    /** Shows another moment; on the event dispatch thread. */
    void show(HemissonView newView) {
        view = newView;
        repaint();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D canvas = (Graphics2D) graphics.create();
        try {
            canvas.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            AffineTransform toScreen = toScreen();
            drawBody(canvas, toScreen);
            drawWheels(canvas, toScreen);
            drawLamps(canvas, toScreen);
            for (int sensor = 0; sensor < Proximity.SENSORS; sensor++) {
                drawBar(canvas, toScreen, sensor);
            }
        } finally {
            canvas.dispose();
        }
    }

    /** From the robot's frame, x ahead and y left, to the screen with ahead up. */
    private AffineTransform toScreen() {
        double scale = Math.min(getWidth(), getHeight()) / (2 * SHOWN_MM);
        return new AffineTransform(0, -scale, -scale, 0, getWidth() / 2.0, getHeight() / 2.0);
    }

    private void drawBody(Graphics2D canvas, AffineTransform toScreen) {
        double hull = Clearance.HULL_MM;
        canvas.setColor(colour("Panel.foreground", Color.GRAY));
        canvas.setStroke(new BasicStroke(view.connected() ? 2f : 1f));
        canvas.draw(toScreen.createTransformedShape(new Ellipse2D.Double(-hull, -hull, 2 * hull, 2 * hull)));
    }

    private void drawWheels(Graphics2D canvas, AffineTransform toScreen) {
        int[] values = {view.wheels().left(), view.wheels().right()};
        for (int wheel = 0; wheel < 2; wheel++) {
            double y = wheel == 0 ? 45 : -45;
            canvas.draw(toScreen.createTransformedShape(new Rectangle2D.Double(-19, y - 4, 38, 8)));
            figure(canvas, toScreen, -30, y, String.valueOf(values[wheel]));
        }
    }

    private void drawLamps(Graphics2D canvas, AffineTransform toScreen) {
        drawLamp(canvas, toScreen, 42, 18, view.leds().left());
        drawLamp(canvas, toScreen, 42, -18, view.leds().right());
        drawLamp(canvas, toScreen, -42, 18, view.leds().pgm());
    }

    private static void drawLamp(Graphics2D canvas, AffineTransform toScreen, double x, double y, boolean on) {
        Ellipse2D lamp = new Ellipse2D.Double(x - 5, y - 5, 10, 10);
        if (on) {
            canvas.fill(toScreen.createTransformedShape(lamp));
        } else {
            canvas.draw(toScreen.createTransformedShape(lamp));
        }
    }

    private void drawBar(Graphics2D canvas, AffineTransform toScreen, int sensor) {
        Proximity seen = view.seen();
        double[] at = BARS[sensor];
        AffineTransform place = new AffineTransform(toScreen);
        place.translate(at[0], at[1]);
        place.rotate(Math.toRadians(at[2]));
        int value = seen == null ? 0 : seen.value(sensor);
        canvas.setColor(colour("Component.accentColor", Color.BLUE));
        canvas.fill(place.createTransformedShape(bar(value / FULL)));
        canvas.setColor(colour("Panel.foreground", Color.GRAY));
        canvas.draw(place.createTransformedShape(bar(1)));
        double direction = Math.toRadians(at[2]);
        boolean ground = sensor >= Proximity.GROUND_RIGHT;
        double beyond = ground ? -FIGURE_MM : BAR_MM + FIGURE_MM;
        figure(
                canvas,
                toScreen,
                at[0] + beyond * Math.cos(direction),
                at[1] + beyond * Math.sin(direction),
                seen == null ? "–" : String.valueOf(value));
    }

    private static Path2D bar(double filled) {
        return new Path2D.Double(new Rectangle2D.Double(0, -BAR_WIDTH_MM / 2, BAR_MM * filled, BAR_WIDTH_MM));
    }

    private static void figure(Graphics2D canvas, AffineTransform toScreen, double x, double y, String text) {
        Point2D at = toScreen.transform(new Point2D.Double(x, y), null);
        float left = (float) (at.getX() - canvas.getFontMetrics().stringWidth(text) / 2.0);
        canvas.drawString(
                text, left, (float) (at.getY() + canvas.getFontMetrics().getAscent() / 2.0));
    }

    private static Color colour(String key, Color otherwise) {
        Color colour = UIManager.getColor(key);
        return colour == null ? otherwise : colour;
    }
}
