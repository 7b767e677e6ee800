package majic.gui.bots;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.geom.Arc2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import majic.gui.kit.LineArt;
import majic.gui.kit.Palette;
import majic.panel.DrawingColors;
import majic.panel.ScaledIcon;

/** Pictures of small buttons. */
enum ActionIcon implements ScaledIcon {
    /** A filled square in the alarm colour. */
    STOP,
    /** An arrow that turns in a circle. */
    RECONNECT,
    /** Two windows, one in front of the other. */
    WINDOW;

    private static final int SIZE = 12;

    @Override
    public void paint(Component on, Graphics2D g) {
        g.setStroke(new BasicStroke(1.4f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.setColor(on.isEnabled() ? color() : Palette.mixed(0.4));
        switch (this) {
            case STOP -> g.fill(new RoundRectangle2D.Double(1.5, 1.5, 9, 9, 2, 2));
            case RECONNECT -> {
                g.draw(new Arc2D.Double(1.5, 1.5, 9, 9, 60, 290, Arc2D.OPEN));
                g.fill(new LineArt().area(7, 0, 11.5, 2.5, 7, 5).shape());
            }
            case WINDOW -> {
                g.draw(new Rectangle2D.Double(4.5, 1, 6.5, 5.5));
                g.setColor(DrawingColors.current().paper());
                g.fill(new Rectangle2D.Double(1, 4.5, 6.5, 6));
                g.setColor(color());
                g.draw(new Rectangle2D.Double(1, 4.5, 6.5, 6));
            }
        }
    }

    private Color color() {
        return this == STOP ? Palette.error() : Palette.mixed(0.85);
    }

    @Override
    public int width() {
        return SIZE;
    }
}
