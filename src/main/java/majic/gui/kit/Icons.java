package majic.gui.kit;

import com.formdev.flatlaf.extras.FlatSVGIcon;
import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.image.BufferedImage;
import javax.swing.Icon;
import org.jspecify.annotations.Nullable;

/**
 * Provides MAJIC's icons. Reading the first one takes a third of a second, so the window is shown without them, and
 * they are read in the background.
 */
public final class Icons {
    private Icons() {}

    /**
     * Returns an icon by its name without {@code .svg}; its grey follows the look and feel. It has its size at once but
     * is empty until it is read.
     */
    public static Icon later(String name, int size) {
        return new LateIcon(name, size);
    }

    /** Returns an icon as an image; reads it from its file. */
    public static Image now(String name, int size) {
        return new FlatSVGIcon(path(name), size, size).getImage();
    }

    /**
     * Reads an icon, so that it can be painted.
     *
     * @param icon made by {@link #later}
     */
    public static void read(Icon icon) {
        if (icon instanceof LateIcon late) {
            late.read();
        }
    }

    private static String path(String name) {
        return "majic/gui/" + name + ".svg";
    }

    private static final class LateIcon implements Icon {
        private final String name;
        private final int size;
        private volatile @Nullable Icon picture;

        LateIcon(String name, int size) {
            this.name = name;
            this.size = size;
        }

        void read() {
            Icon icon = new FlatSVGIcon(path(name), size, size);
            Graphics2D nowhere = new BufferedImage(1, 1, BufferedImage.TYPE_INT_ARGB).createGraphics();
            icon.paintIcon(null, nowhere, 0, 0);
            nowhere.dispose();
            picture = icon;
        }

        @Override
        public void paintIcon(@Nullable Component component, Graphics g, int x, int y) {
            Icon icon = picture;
            if (icon != null) {
                icon.paintIcon(component, g, x, y);
            }
        }

        @Override
        public int getIconWidth() {
            return UIScale.scale(size);
        }

        @Override
        public int getIconHeight() {
            return UIScale.scale(size);
        }
    }
}
