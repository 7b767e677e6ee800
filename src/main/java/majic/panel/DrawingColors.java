package majic.panel;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import javax.swing.UIManager;

/**
 * Colours and font for drawing in the present look and feel. Must be created anew for every painting. Immutable.
 *
 * @param line for outlines and figures
 * @param paper the background
 * @param accent for sensor readings
 * @param alarm for warnings
 */
public record DrawingColors(Color line, Color paper, Color accent, Color alarm) {
    private static final float FIGURES = 0.85f;

    /** Alarm colour for a light background, where the look and feel's own red has too little contrast. */
    private static final Color ALARM_ON_LIGHT = new Color(0xB3261E);

    private static final Color ALARM_ON_DARK = new Color(0xFF9E95);

    private static final Color ACCENT_ON_LIGHT = new Color(0x236DB2);
    private static final Color ACCENT_ON_DARK = new Color(0x579BF6);

    private static final Color GOOD_ON_LIGHT = new Color(0x2E7D32);
    private static final Color GOOD_ON_DARK = new Color(0x7BCB80);

    /** Shares of the line's colour in secondary text and in shapes; on dark surfaces less has too little contrast. */
    private static final double FAINT_ON_LIGHT = 0.7;

    private static final double FAINT_ON_DARK = 0.95;
    private static final double SHAPE_ON_LIGHT = 0.5;
    private static final double SHAPE_ON_DARK = 0.7;

    /**
     * Returns the colours of the present look and feel; default ones without a look and feel.
     *
     * @return the colours at this moment
     */
    public static DrawingColors current() {
        Color paper = color("Panel.background", Color.WHITE);
        return new DrawingColors(
                color("Label.foreground", Color.BLACK),
                paper,
                isDark(paper) ? ACCENT_ON_DARK : ACCENT_ON_LIGHT,
                isDark(paper) ? ALARM_ON_DARK : ALARM_ON_LIGHT);
    }

    private static boolean isDark(Color paper) {
        return paper.getRed() + paper.getGreen() + paper.getBlue() < 3 * 128;
    }

    /**
     * Returns the colour of secondary text.
     *
     * @return with a contrast of at least 4.5 on panels, maps and text areas
     */
    public Color faint() {
        return grey(isDark(paper) ? FAINT_ON_DARK : FAINT_ON_LIGHT);
    }

    /**
     * Returns the colour of secondary shapes that carry a meaning.
     *
     * @return with a contrast of at least 3 on panels, maps and text areas
     */
    public Color shape() {
        return grey(isDark(paper) ? SHAPE_ON_DARK : SHAPE_ON_LIGHT);
    }

    /**
     * Returns the colour of a part in working order.
     *
     * @return with a contrast of at least 3 on panels, maps and text areas
     */
    public Color good() {
        return isDark(paper) ? GOOD_ON_DARK : GOOD_ON_LIGHT;
    }

    /**
     * Returns paler colours, for values that are no longer current.
     *
     * @return paler colours on the same background
     */
    public DrawingColors faded() {
        return new DrawingColors(grey(0.45), paper, grey(0.4), grey(0.4));
    }

    private static Color color(String key, Color otherwise) {
        Color known = UIManager.getColor(key);
        return known == null ? otherwise : known;
    }

    /**
     * Sets smooth edges and a font slightly smaller than that of the surrounding text.
     *
     * @param pen the pen to change; it is not restored
     */
    public static void prepare(Graphics2D pen) {
        pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        pen.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        pen.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        Font label = UIManager.getFont("Label.font");
        Font font = label == null ? pen.getFont() : label;
        pen.setFont(font.deriveFont(font.getSize2D() * FIGURES));
    }

    /**
     * Mixes the line's colour with the background.
     *
     * @param share of the line's colour, 0 to 1
     * @return opaque
     */
    public Color grey(double share) {
        return mixed(line, share);
    }

    /**
     * Mixes the accent with the background. Much faster to paint than {@link #wash}, so suited to thousands of marks.
     *
     * @param share of the accent, 0 to 1
     * @return opaque
     */
    public Color tint(double share) {
        return mixed(accent, share);
    }

    /**
     * Returns the accent, translucent.
     *
     * @param opacity 0 to 1
     * @return a translucent colour
     */
    public Color wash(double opacity) {
        return translucent(accent, opacity);
    }

    /**
     * Makes a colour translucent.
     *
     * @param color the colour; its own opacity is ignored
     * @param opacity 0 to 1
     * @return the translucent colour
     */
    public static Color translucent(Color color, double opacity) {
        return new Color(color.getRed(), color.getGreen(), color.getBlue(), (int) Math.round(255 * opacity));
    }

    /**
     * Creates a round-ended stroke.
     *
     * @param width in the units of the pen it is set on
     * @return solid
     */
    public static BasicStroke stroke(double width) {
        return new BasicStroke((float) width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    }

    private Color mixed(Color color, double share) {
        return new Color(
                mix(color.getRed(), paper.getRed(), share),
                mix(color.getGreen(), paper.getGreen(), share),
                mix(color.getBlue(), paper.getBlue(), share));
    }

    private static int mix(int one, int other, double share) {
        return (int) Math.round(one * share + other * (1 - share));
    }
}
