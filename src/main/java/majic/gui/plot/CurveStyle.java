package majic.gui.plot;

import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;

/**
 * Tells the curves of a plot apart: eight colours that colour-blind users can distinguish too, each with a solid, a
 * dashed and a dotted line. Immutable.
 *
 * @param number the curve's number in its plot, from 0
 */
record CurveStyle(int number) {
    private static final float WIDTH = 1.6f;
    private static final Color[] LIGHT = {
        new Color(0x0072B2), new Color(0xC04E00), new Color(0x007A5A), new Color(0x9C3F80),
        new Color(0x8A6D00), new Color(0x5B4FC4), new Color(0x7A4B2A), new Color(0x555555)
    };
    private static final Color[] DARK = {
        new Color(0x4FA8DC), new Color(0xF08A45), new Color(0x3FC29A), new Color(0xDB88BF),
        new Color(0xE0C040), new Color(0xA79DF5), new Color(0xC89A74), new Color(0xB0B0B0)
    };
    private static final float[][] DASHES = {{}, {7, 4}, {1.5f, 3.5f}};

    /** Returns the colour in the present look and feel. */
    Color color() {
        return color(FlatLaf.isLafDark());
    }

    /** Returns the colour on a dark or a light background. */
    Color color(boolean dark) {
        Color[] colors = dark ? DARK : LIGHT;
        return colors[number % colors.length];
    }

    /** Returns the stroke, wider for larger fonts. */
    BasicStroke stroke() {
        float scale = UIScale.getUserScaleFactor();
        float[] dash = DASHES[number / LIGHT.length % DASHES.length].clone();
        for (int index = 0; index < dash.length; index++) {
            dash[index] *= scale;
        }
        return new BasicStroke(
                WIDTH * scale, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND, 1, dash.length == 0 ? null : dash, 0);
    }
}
