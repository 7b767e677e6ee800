package majic.panel;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import javax.swing.Icon;

/**
 * An icon that is drawn, and whose size follows the font of the look and feel. Where the system itself scales windows,
 * it is drawn at that scale too, so it is never blurred.
 */
public interface ScaledIcon extends Icon {
    /**
     * Returns the width at the normal font size.
     *
     * @return pixels
     */
    int width();

    /**
     * Returns the height at the normal font size; that of a square unless it is overridden.
     *
     * @return pixels
     */
    default int height() {
        return width();
    }

    /**
     * Draws the icon.
     *
     * @param on the component that shows the icon
     * @param pen smooth, in the pixels of {@link #width} and {@link #height}, from the upper left corner; its settings
     *     are discarded afterwards
     */
    void paint(Component on, Graphics2D pen);

    @Override
    default void paintIcon(Component component, Graphics graphics, int x, int y) {
        Graphics2D pen = (Graphics2D) graphics.create();
        DrawingColors.prepare(pen);
        pen.translate(x, y);
        double scale = UIScale.getUserScaleFactor();
        pen.scale(scale, scale);
        paint(component, pen);
        pen.dispose();
    }

    @Override
    default int getIconWidth() {
        return UIScale.scale(width());
    }

    @Override
    default int getIconHeight() {
        return UIScale.scale(height());
    }
}
