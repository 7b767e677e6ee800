package majic.gui.kit;

import java.awt.Color;
import java.awt.Component;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.RoundRectangle2D;
import javax.swing.UIManager;
import majic.panel.ScaledIcon;

/**
 * A robot's number on its colour: a disc for the numbers up to 10, a rounded square for larger ones, which is wider
 * from 100.
 *
 * @param number the robot's number
 * @param size height in pixels at the normal font size, and width of a number below 100
 */
public record NumberBadge(int number, int size) implements ScaledIcon {
    private static final int LAST_DISC = 10;
    private static final int LAST_SQUARE = 99;
    private static final float FONT_SIZE = 0.58f;

    @Override
    public void paint(Component on, Graphics2D pen) {
        paint(pen, width() / 2.0, size / 2.0, "" + number);
    }

    /**
     * Paints the badge around a point.
     *
     * @param text the number, perhaps with a mark behind it
     */
    public void paint(Graphics2D pen, double x, double y, String text) {
        Graphics2D g = (Graphics2D) pen.create();
        Color color = RobotColors.of(number);
        g.setColor(color);
        g.fill(
                number <= LAST_DISC
                        ? new Ellipse2D.Double(x - size / 2.0, y - size / 2.0, size, size)
                        : new RoundRectangle2D.Double(
                                x - width() / 2.0, y - size / 2.0, width(), size, size / 3.0, size / 3.0));
        g.setFont(UIManager.getFont("Label.font").deriveFont(Font.BOLD, size * FONT_SIZE));
        FontMetrics metrics = g.getFontMetrics();
        g.setColor(RobotColors.textOn(color));
        g.drawString(text, (float) (x - metrics.stringWidth(text) / 2.0), (float)
                (y + (metrics.getAscent() - metrics.getDescent()) / 2.0));
        g.dispose();
    }

    @Override
    public int width() {
        return number <= LAST_SQUARE ? size : size * 3 / 2;
    }

    @Override
    public int height() {
        return size;
    }
}
