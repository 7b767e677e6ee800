package majic.panel;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import javax.swing.JPanel;
import javax.swing.UIManager;
import majic.bot.Range;
import majic.text.NumberText;
import org.jspecify.annotations.Nullable;

/**
 * Shows a value between two limits around zero: its name, the figure with its sign, and a bar that extends from zero to
 * the side of the value, with the limits at its ends. Must be used on the event dispatch thread.
 */
public final class Gauge extends JPanel {
    private static final long serialVersionUID = 1;
    private static final int BAR_PX = 9;
    private static final int GAP = 5;

    /** Text for the width of the limits, so that bars of gauges below each other start at the same position. */
    private static final String LONGEST_LIMIT = "+1000";

    private String title;
    private final String unit;
    private final boolean positiveLeft;
    private transient Range limits = new Range(-1, 1);
    private transient @Nullable Double value;

    /**
     * Creates a gauge without a value.
     *
     * @param parameter name of the parameter; the title is this name in plain words
     * @param unit behind the figure
     * @param positiveLeft whether positive values point to the left, as turns do
     */
    public Gauge(String parameter, String unit, boolean positiveLeft) {
        this.title = ReadingText.label(parameter);
        setFocusable(true);
        PlotLink.install(this, List.of(parameter));
        this.unit = unit;
        this.positiveLeft = positiveLeft;
        setName(parameter);
        setOpaque(false);
    }

    /**
     * Sets the title, which is the parameter's name in plain English words otherwise.
     *
     * @param label a few words in the user's language
     * @return this gauge
     */
    public Gauge labelled(String label) {
        title = label;
        return this;
    }

    /**
     * Shows a value.
     *
     * @param newValue in the gauge's unit; null when it is not known
     * @param newLimits the lowest below zero, the highest above; a value beyond fills the bar
     */
    public void show(@Nullable Double newValue, Range newLimits) {
        value = newValue;
        limits = newLimits;
        getAccessibleContext().setAccessibleName(title + " " + figure());
        repaint();
    }

    /**
     * Returns the figure as it is displayed.
     *
     * @return with sign and unit; a dash when the value is not known
     */
    public String figure() {
        Double now = value;
        return now == null ? "\u2013" : NumberText.signed(now) + " " + unit;
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setFont(UIManager.getFont("Label.font"));
    }

    @Override
    public Dimension getPreferredSize() {
        int width = getFontMetrics(getFont()).stringWidth(title + LONGEST_LIMIT + " " + unit);
        return new Dimension(width + 2 * GAP, 2 * textHeight() - 2);
    }

    @Override
    public Dimension getMinimumSize() {
        return getPreferredSize();
    }

    private int textHeight() {
        return getFontMetrics(getFont()).getHeight();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D pen = (Graphics2D) graphics.create();
        DrawingColors colors =
                isEnabled() ? DrawingColors.current() : DrawingColors.current().faded();
        DrawingColors.prepare(pen);
        pen.setFont(getFont());
        FontMetrics metrics = pen.getFontMetrics();
        pen.setColor(DrawingColors.current().line());
        pen.drawString(title, 0, metrics.getAscent());
        pen.setColor(isEnabled() ? DrawingColors.current().line() : UIManager.getColor("Label.disabledForeground"));
        pen.drawString(figure(), getWidth() - metrics.stringWidth(figure()), metrics.getAscent());
        DrawingColors.prepare(pen);
        paintScale(pen, colors);
        pen.dispose();
    }

    private void paintScale(Graphics2D pen, DrawingColors colors) {
        FontMetrics metrics = pen.getFontMetrics();
        String left = NumberText.signed(positiveLeft ? limits.max() : limits.min());
        String right = NumberText.signed(positiveLeft ? limits.min() : limits.max());
        double middle = textHeight() + (textHeight() - 2) / 2.0;
        float base = (float) (middle + metrics.getAscent() / 2.0 - 1);
        pen.setColor(DrawingColors.current().faint());
        pen.drawString(left, 0, base);
        pen.drawString(right, getWidth() - metrics.stringWidth(right), base);
        int ends = Math.max(metrics.stringWidth(LONGEST_LIMIT), metrics.stringWidth(left + right) / 2) + GAP;
        paintBar(
                pen,
                colors,
                new Rectangle2D.Double(
                        ends, middle - UIScale.scale(BAR_PX) / 2.0, getWidth() - 2 * ends, UIScale.scale(BAR_PX)));
    }

    private void paintBar(Graphics2D pen, DrawingColors colors, Rectangle2D bar) {
        pen.setColor(colors.grey(0.1));
        pen.fill(new RoundRectangle2D.Double(bar.getX(), bar.getY(), bar.getWidth(), bar.getHeight(), 4, 4));
        double zero = bar.getCenterX();
        double tip = zero + share() * bar.getWidth() / 2;
        pen.setColor(colors.accent());
        pen.fill(
                new Rectangle2D.Double(Math.min(zero, tip), bar.getY() + 1, Math.abs(tip - zero), bar.getHeight() - 2));
        pen.setColor(colors.grey(0.35));
        pen.setStroke(DrawingColors.stroke(1));
        pen.draw(new RoundRectangle2D.Double(bar.getX(), bar.getY(), bar.getWidth(), bar.getHeight(), 4, 4));
        pen.setColor(colors.grey(0.85));
        pen.draw(new Line2D.Double(zero, bar.getY() - 2, zero, bar.getMaxY() + 2));
    }

    /** Returns the extent of the bar, from −1, all the way to the left, to 1, all the way to the right. */
    private double share() {
        Double now = value;
        if (now == null) {
            return 0;
        }
        double limit = now < 0 ? -limits.min() : limits.max();
        double share = Math.max(-1, Math.min(1, now / Math.max(1e-9, limit)));
        return positiveLeft ? -share : share;
    }
}
