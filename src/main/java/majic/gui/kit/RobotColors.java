package majic.gui.kit;

import com.formdev.flatlaf.FlatLaf;
import java.awt.Color;

/**
 * Assigns a colour to each robot number; the colours can be distinguished by colour-blind users too, in the light and
 * the dark look.
 */
public final class RobotColors {
    private static final Color[] LIGHT = {
        new Color(0x0072B2), new Color(0xC04E00), new Color(0x007A5A), new Color(0x9C3F80),
        new Color(0x8A6D00), new Color(0x3D6FB6), new Color(0x7A4B2A), new Color(0x555555)
    };
    private static final Color[] DARK = {
        new Color(0x4FA8DC), new Color(0xF08A45), new Color(0x3FC29A), new Color(0xDB88BF),
        new Color(0xE0C040), new Color(0x9DB8F0), new Color(0xC89A74), new Color(0xB0B0B0)
    };

    private RobotColors() {}

    /** Returns the colour of a robot in the present look and feel. */
    public static Color of(int number) {
        Color[] colors = FlatLaf.isLafDark() ? DARK : LIGHT;
        return colors[Math.floorMod(number - 1, colors.length)];
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
