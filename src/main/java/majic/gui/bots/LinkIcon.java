package majic.gui.bots;

import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import majic.panel.DrawingColors;
import majic.panel.ScaledIcon;

/**
 * The quality of a connection as bars of growing height; missing bars are outlined.
 *
 * @param bars how many are filled, 0 to {@link LinkMeter#MOST_BARS}
 */
record LinkIcon(int bars) implements ScaledIcon {
    private static final int STEP = 5;
    private static final int HEIGHT = 12;

    @Override
    public void paint(Component on, Graphics2D g) {
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
