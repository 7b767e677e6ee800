package majic.gui.kit;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import javax.swing.Icon;
import javax.swing.UIManager;
import majic.panel.ScaledIcon;

/** Provides MAJIC's icons. They are drawn, since a library for drawings in files would delay the window. */
public final class Icons {
    private static final float STROKE = 1.8f;

    /** Side of the square in which the icon of the program is drawn. */
    private static final double PROGRAM_SIDE = 64;

    private Icons() {}

    /**
     * Returns an icon in the grey of the look and feel.
     *
     * @param size width and height at the normal font size, pixels
     */
    public static Icon of(Pictogram pictogram, int size) {
        return new LineIcon(pictogram, size);
    }

    /**
     * Draws the icon of the program. Needs no display.
     *
     * @param size width and height, pixels
     */
    public static BufferedImage program(int size) {
        BufferedImage image = new BufferedImage(size, size, BufferedImage.TYPE_INT_ARGB);
        Graphics2D pen = image.createGraphics();
        pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        pen.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        pen.scale(size / PROGRAM_SIDE, size / PROGRAM_SIDE);
        pen.setColor(new Color(0x1F4E79));
        pen.fillRoundRect(2, 2, 60, 60, 28, 28);
        pen.setColor(new Color(0xF2B134));
        pen.fill(new LineArt().area(32, 10, 39, 19, 25, 19).shape());
        pen.setColor(Color.WHITE);
        pen.setStroke(round(6.5f));
        pen.draw(new LineArt().line(14, 48, 14, 26, 32, 39, 50, 26, 50, 48).shape());
        pen.dispose();
        return image;
    }

    private static BasicStroke round(float width) {
        return new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    }

    /** The icon of a pictogram. */
    private record LineIcon(Pictogram pictogram, int width) implements ScaledIcon {
        @Override
        public void paint(Component on, Graphics2D pen) {
            double scale = (double) width / Pictogram.SIDE;
            Color grey = UIManager.getColor(on.isEnabled() ? "Actions.Grey" : "Button.disabledText");
            pen.setColor(grey == null ? Color.GRAY : grey);
            pen.setStroke(round((float) (STROKE * scale)));
            pen.draw(AffineTransform.getScaleInstance(scale, scale).createTransformedShape(pictogram.lines()));
        }
    }
}
