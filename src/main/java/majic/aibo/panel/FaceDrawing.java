package majic.aibo.panel;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import java.util.Optional;
import majic.aibo.body.DogState;
import majic.aibo.body.Sensor;
import majic.panel.DrawingColors;

/**
 * The face as one looks into it, in mm around its middle: the 14 LEDs behind the visor in pairs from the chin upwards,
 * the mouth as far open as it is, ears, the mode indicator, and the touch sensors of head and chin. Which LED a name
 * lights on the real dog also depends on its LED mode.
 */
final class FaceDrawing {
    static final double HALF_WIDTH_MM = 98;
    static final double TOP_MM = 76;
    static final double FOOT_MM = 84;

    private static final double OUTLINE_MM = 3;
    private static final double LED_MM = 5.2;
    private static final double ROW_MM = 13;
    private static final List<Double> OFF_MIDDLE_MM = List.of(9.0, 14.0, 18.0, 20.0, 19.0, 16.0, 10.0);
    private static final List<String> MODES = List.of("modeR", "modeG", "modeB");
    private static final List<Color> MODE_COLOURS = List.of(LedDrawing.RED, LedDrawing.GREEN, LedDrawing.BLUE);

    private final DogState dog;
    private final DrawingColors colors;
    private final boolean live;
    private final LedDrawing leds;

    /** A live dog's LEDs shine. */
    FaceDrawing(DogState dog, DrawingColors colors, boolean live) {
        this.dog = dog;
        this.colors = colors;
        this.live = live;
        this.leds = new LedDrawing(colors, LED_MM, colors.grey(0.55));
    }

    /** Returns whether an LED is drawn in the face only. */
    static boolean isOnlyThere(String led) {
        return led.startsWith("ledF") || MODES.contains(led);
    }

    /** Paints with y upwards. */
    void paint(Graphics2D pen) {
        paintEar(pen, -1, "earR");
        paintEar(pen, 1, "earL");
        paintJaw(pen);
        part(pen, oval(0, 6, 58, 60), colors.grey(0.08));
        part(pen, new RoundRectangle2D.Double(-33, -48, 66, 104, 62, 78), HeadDrawing.visor(colors));
        paintFace(pen);
        paintTop(pen);
        paintModes(pen);
    }

    private void paintFace(Graphics2D pen) {
        for (int led = 0; led < 2 * OFF_MIDDLE_MM.size(); led++) {
            int row = led / 2;
            double x = (led % 2 == 0 ? -1 : 1) * OFF_MIDDLE_MM.get(row);
            double y = 4 + ROW_MM * (row - (OFF_MIDDLE_MM.size() - 1) / 2.0);
            leds.paint(pen, x, y, LedDrawing.WHITE, amount("ledF" + (led + 1)));
        }
    }

    /** The head's sensor with its two LEDs beside it, and the light of the wireless network. */
    private void paintTop(Graphics2D pen) {
        pad(pen, new RoundRectangle2D.Double(-15, 58, 30, 13, 13, 13), Sensor.HEAD_TOUCH);
        leds.paint(pen, -27, 61, LedDrawing.ORANGE, amount("ledHC"));
        leds.paint(pen, 27, 61, LedDrawing.WHITE, amount("ledHW"));
        leds.paint(pen, 43, 50, LedDrawing.BLUE, amount("ledWIFI"));
    }

    private void paintModes(Graphics2D pen) {
        for (int mode = 0; mode < MODES.size(); mode++) {
            leds.paint(pen, -45, 32 - mode * ROW_MM, MODE_COLOURS.get(mode), amount(MODES.get(mode)));
            leds.paint(pen, 45, 32 - mode * ROW_MM, MODE_COLOURS.get(mode), amount(MODES.get(mode)));
        }
    }

    private void paintJaw(Graphics2D pen) {
        double open = -dog.senses().number(Sensor.MOUTH).orElse(-3.0);
        double drop = 30 * Math.sin(Math.toRadians(Math.max(0, open)));
        part(pen, new RoundRectangle2D.Double(-30, -62 - drop, 60, 40 + drop, 44, 44), colors.grey(0.75));
        part(pen, new RoundRectangle2D.Double(-27, -64 - drop, 54, 22, 22, 22), colors.grey(0.3));
        pad(pen, new RoundRectangle2D.Double(-11, -70 - drop, 22, 11, 11, 11), Sensor.CHIN);
    }

    private void paintEar(Graphics2D pen, int side, String device) {
        boolean flicked = dog.leds().amount(device).orElse(0.0) > 0.5;
        AffineTransform hanging = AffineTransform.getTranslateInstance(side * 52, 36);
        hanging.rotate(side * Math.toRadians(flicked ? 50 : 14));
        part(pen, hanging.createTransformedShape(oval(0, -30, 14, 36)), colors.grey(0.45));
    }

    private Optional<Double> amount(String led) {
        return live ? dog.leds().amount(led) : Optional.empty();
    }

    private void pad(Graphics2D pen, Shape shape, Sensor sensor) {
        part(pen, shape, dog.senses().isPressed(sensor) ? colors.accent() : colors.paper());
    }

    private void part(Graphics2D pen, Shape shape, Color color) {
        pen.setColor(color);
        pen.fill(shape);
        pen.setColor(colors.grey(0.8));
        pen.setStroke(DrawingColors.stroke(OUTLINE_MM));
        pen.draw(shape);
    }

    private static Ellipse2D oval(double x, double y, double halfWidth, double halfHeight) {
        return new Ellipse2D.Double(x - halfWidth, y - halfHeight, 2 * halfWidth, 2 * halfHeight);
    }
}
