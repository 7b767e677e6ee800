package majic.panel;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import javax.swing.UIManager;

/**
 * What the drawing is drawn with: the colours and the font of the present look. Taken anew for every painting. Immutable.
 *
 * @param line for outlines and figures
 * @param paper what it is drawn on
 * @param accent for what the robot senses
 * @param alarm for what needs attention
 */
public record Ink(Color line, Color paper, Color accent, Color alarm) {
    private static final float FIGURES = 0.85f;

    /** The look's own red is too faint to be read on its paper. */
    private static final Color ALARM_ON_LIGHT = new Color(0xB3261E);

    private static final Color ALARM_ON_DARK = new Color(0xFF8A80);

    /**
     * The present look's; plain ones where there is no look.
     *
     * @return taken at this moment
     */
    public static Ink ofTheLook() {
        Color paper = color("Panel.background", Color.WHITE);
        return new Ink(
                color("Label.foreground", Color.BLACK),
                paper,
                color("Component.linkColor", Color.BLUE),
                isDark(paper) ? ALARM_ON_DARK : ALARM_ON_LIGHT);
    }

    private static boolean isDark(Color paper) {
        return paper.getRed() + paper.getGreen() + paper.getBlue() < 3 * 128;
    }

    /**
     * For what is no longer so: everything thin, nothing stands out.
     *
     * @return the same paper with paler colours
     */
    public Ink faded() {
        return new Ink(grey(0.45), paper, grey(0.4), grey(0.4));
    }

    private static Color color(String key, Color otherwise) {
        Color known = UIManager.getColor(key);
        return known == null ? otherwise : known;
    }

    /**
     * Makes edges smooth and figures a little smaller than the text around.
     *
     * @param pen changed for good
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
     * The line's colour thinned with the paper's.
     *
     * @param share of the line's colour, 0 to 1
     * @return opaque
     */
    public Color grey(double share) {
        return mixed(line, share);
    }

    /**
     * The accent thinned with the paper's colour. Painted far quicker than {@link #wash}, for what there are thousands of.
     *
     * @param share of the accent, 0 to 1
     * @return opaque
     */
    public Color tint(double share) {
        return mixed(accent, share);
    }

    /**
     * The accent, translucent.
     *
     * @param opacity 0 to 1
     * @return what lies below shows through
     */
    public Color wash(double opacity) {
        return translucent(accent, opacity);
    }

    /**
     * A colour through which what lies below can be seen.
     *
     * @param color its opacity does not count
     * @param opacity 0 to 1
     * @return the same colour
     */
    public static Color translucent(Color color, double opacity) {
        return new Color(color.getRed(), color.getGreen(), color.getBlue(), (int) Math.round(255 * opacity));
    }

    /**
     * A round-ended stroke.
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
