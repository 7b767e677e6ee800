package majic.panel.map;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Point2D;
import java.util.List;
import majic.panel.DrawingColors;

/** Draws echoes as dots that get smaller and paler with age, but never disappear. */
public final class EchoesDrawing {
    private static final double[] UNTIL_S = {0.5, 3, 15, 60, Double.POSITIVE_INFINITY};
    private static final double[] RADIUS_PX = {3.4, 2.9, 2, 1.5, 1.5};
    private static final double[] SHARE = {1, 0.8, 0.65, 0.6, 0.45};

    /** From this age on they are squares, because there can be thousands of them. */
    private static final int FIRST_SQUARE = 2;

    private final MapView view;
    private final Color[] colors = new Color[UNTIL_S.length];

    /**
     * Creates a drawing of one moment.
     *
     * @param palette the colours of the look
     * @param view from the floor to the pixels
     */
    public EchoesDrawing(DrawingColors palette, MapView view) {
        this.view = view;
        for (int age = 0; age < colors.length; age++) {
            colors[age] = palette.tint(SHARE[age]);
        }
    }

    /**
     * Paints the newest on top.
     *
     * @param pen in pixels; its colour and hints change
     * @param oldestFirst what to paint
     * @param nowNanos the present time, on the clock of the echoes
     */
    public void paint(Graphics2D pen, List<Echoes.Echo> oldestFirst, long nowNanos) {
        AffineTransform floor = view.transform();
        Point2D.Double at = new Point2D.Double();
        int penAge = -1;
        for (Echoes.Echo echo : oldestFirst) {
            at.setLocation(echo.xMm(), echo.yMm());
            floor.transform(at, at);
            if (isSeen(at)) {
                int age = age((nowNanos - echo.atNanos()) / 1e9);
                if (age != penAge) {
                    penAge = age;
                    prepare(pen, age);
                }
                paintDot(pen, at, age);
            }
        }
    }

    /** Smooth edges would cost squares ten times the time. */
    private void prepare(Graphics2D pen, int age) {
        pen.setColor(colors[age]);
        pen.setRenderingHint(
                RenderingHints.KEY_ANTIALIASING,
                age < FIRST_SQUARE ? RenderingHints.VALUE_ANTIALIAS_ON : RenderingHints.VALUE_ANTIALIAS_OFF);
    }

    private static void paintDot(Graphics2D pen, Point2D at, int age) {
        double radius = RADIUS_PX[age];
        if (age < FIRST_SQUARE) {
            pen.fill(new Ellipse2D.Double(at.getX() - radius, at.getY() - radius, 2 * radius, 2 * radius));
        } else {
            int side = (int) (2 * radius);
            pen.fillRect((int) Math.round(at.getX() - radius), (int) Math.round(at.getY() - radius), side, side);
        }
    }

    private boolean isSeen(Point2D at) {
        return at.getX() >= 0 && at.getX() <= view.width() && at.getY() >= 0 && at.getY() <= view.height();
    }

    private static int age(double seconds) {
        int age = 0;
        while (seconds > UNTIL_S[age]) {
            age++;
        }
        return age;
    }
}
