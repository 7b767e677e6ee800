package majic.gui.kit;

import com.formdev.flatlaf.FlatLaf;
import java.awt.Color;
import javax.swing.UIManager;
import majic.panel.DrawingColors;

/** Colours with a meaning, readable in the present look and feel. */
public final class Palette {
    private Palette() {}

    public static Color text() {
        return UIManager.getColor("Label.foreground");
    }

    /** Returns the colour of secondary text. */
    public static Color faint() {
        return DrawingColors.current().faint();
    }

    public static Color link() {
        return DrawingColors.current().accent();
    }

    public static Color command() {
        return FlatLaf.isLafDark() ? new Color(0x7FBEFA) : new Color(0x1560A8);
    }

    /** Returns the colour of secondary shapes that carry a meaning. */
    public static Color shape() {
        return DrawingColors.current().shape();
    }

    /** Returns the colour of lines that no robot crosses. */
    public static Color forbidden() {
        return FlatLaf.isLafDark() ? new Color(0xE08BF0) : new Color(0x9C27B0);
    }

    public static Color error() {
        return DrawingColors.current().alarm();
    }

    /** Returns the background of texts; readable on {@link #error()} too. */
    public static Color paper() {
        return UIManager.getColor("TextPane.background");
    }

    /**
     * Returns the text colour mixed with the background.
     *
     * @param share share of the text colour, 0 to 1
     */
    public static Color mixed(double share) {
        return mixed(text(), UIManager.getColor("Panel.background"), share);
    }

    /**
     * Returns a mixture of two colours.
     *
     * @param share share of the first one, 0 to 1
     */
    public static Color mixed(Color one, Color other, double share) {
        return new Color(
                mix(one.getRed(), other.getRed(), share),
                mix(one.getGreen(), other.getGreen(), share),
                mix(one.getBlue(), other.getBlue(), share));
    }

    private static int mix(int one, int other, double share) {
        return (int) Math.round(one * share + other * (1 - share));
    }
}
