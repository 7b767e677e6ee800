package majic.gui.kit;

import com.formdev.flatlaf.FlatLaf;
import java.awt.Color;

/**
 * Assigns a colour to each robot number: twenty that differ visibly in the light and in the dark look, the first five
 * by colour-blind users too. A robot is never identified by its colour alone; its number is always drawn with it.
 */
public final class RobotColors {
    private static final int[] LIGHT = {
        0x0072B2, 0xC04E00, 0x007A5A, 0x9C3F80, 0x8A6D00,
        0x0000BB, 0x443322, 0xFF1155, 0x9966FF, 0x880022,
        0x224400, 0x997777, 0x449900, 0x114444, 0x444466,
        0xFF00AA, 0x888866, 0x008899, 0x777799, 0x9900DD
    };
    private static final int[] DARK = {
        0x4FA8DC, 0xF08A45, 0x3FC29A, 0xDB88BF, 0xE0C040,
        0x88FF11, 0xDDDDFF, 0x00EEFF, 0xFFDDCC, 0x77AA22,
        0xDDEEBB, 0xAA99FF, 0xAA9977, 0x77AAAA, 0xCC9999,
        0xDDEE00, 0x66FFAA, 0xFF44FF, 0xFF6688, 0x00CC44
    };

    private RobotColors() {}

    /** Returns the colour of a robot in the present look and feel. */
    public static Color of(int number) {
        int[] colors = FlatLaf.isLafDark() ? DARK : LIGHT;
        return new Color(colors[Math.floorMod(number - 1, colors.length)]);
    }

    /** Returns black or white, whichever is easier to read on a colour. */
    public static Color textOn(Color color) {
        return contrast(color, Color.BLACK) > contrast(color, Color.WHITE) ? Color.BLACK : Color.WHITE;
    }

    /** Returns the contrast of two opaque colours as WCAG 2 defines it, 1 to 21. */
    static double contrast(Color one, Color other) {
        double lighter = Math.max(luminance(one), luminance(other));
        double darker = Math.min(luminance(one), luminance(other));
        return (lighter + 0.05) / (darker + 0.05);
    }

    private static double luminance(Color color) {
        return 0.2126 * linear(color.getRed()) + 0.7152 * linear(color.getGreen()) + 0.0722 * linear(color.getBlue());
    }

    private static double linear(int channel) {
        double share = channel / 255.0;
        return share <= 0.04045 ? share / 12.92 : Math.pow((share + 0.055) / 1.055, 2.4);
    }
}
