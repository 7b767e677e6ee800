package majic.gui.bots;

import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.OptionalInt;
import majic.panel.DrawingColors;
import majic.panel.ScaledIcon;

/**
 * The quality of a connection as bars of growing height; missing bars are outlined.
 *
 * @param quality how many are filled, 0 to {@link LinkMeter#MOST_BARS}; nothing is drawn if it is empty
 */
record LinkIcon(OptionalInt quality) implements ScaledIcon {
    private static final int STEP = 5;
    private static final int HEIGHT = 12;

    @Override
    public void paint(Component on, Graphics2D g) {
        quality.ifPresent(bars -> paint(g, bars));
    }

    private static void paint(Graphics2D g, int bars) {
        DrawingColors colors = DrawingColors.current();
        g.setStroke(DrawingColors.stroke(1));
        for (int bar = 0; bar < LinkMeter.MOST_BARS; bar++) {
            double height = 4.0 * (bar + 1) - 1;
            Rectangle2D shape = new Rectangle2D.Double(bar * STEP + 0.5, HEIGHT - height - 0.5, STEP - 2, height);
            g.setColor(bars <= 1 ? colors.alarm() : colors.grey(0.6));
            if (bar < bars) {
                g.fill(shape);
            }
            g.draw(shape);
        }
    }

    @Override
    public int width() {
        return LinkMeter.MOST_BARS * STEP;
    }

    @Override
    public int height() {
        return HEIGHT;
    }
}
