package majic.gui.completion;

import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Toolkit;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.ListCellRenderer;
import javax.swing.UIManager;
import javax.swing.plaf.basic.BasicGraphicsUtils;
import majic.gui.kit.Palette;
import majic.script.help.Completion;
import org.jspecify.annotations.Nullable;

/**
 * Paints a completion in three columns: the word, what it takes, and its explanation. Must be used on the event
 * dispatch thread.
 */
final class CompletionCell extends JLabel implements ListCellRenderer<Completion> {
    private static final long serialVersionUID = 1L;
    /** Widths in characters. */
    private static final int WIDEST_VALUES = 32;

    private static final int WIDEST = 95;

    private transient Completion entry = new Completion("", "", "");
    private boolean selected;
    private int character = 8;
    private int words;
    private int values;

    /**
     * Sets the widths of the columns and the preferred size, so that the entries fit.
     *
     * @param entries all that are shown together
     * @param font of the list
     */
    public void measure(List<Completion> entries, Font font) {
        setFont(font);
        FontMetrics plain = getFontMetrics(font);
        character = plain.charWidth('m');
        words = widest(entries, Completion::text, getFontMetrics(font.deriveFont(Font.BOLD)));
        values = Math.min(WIDEST_VALUES * character, widest(entries, Completion::values, plain));
        int explanations = widest(entries, Completion::explanation, plain);
        int width = 2 * character + column(words) + column(values) + explanations;
        setPreferredSize(new Dimension(Math.min(WIDEST * character, width), plain.getHeight() + character / 2));
    }

    private static int widest(List<Completion> entries, Function<Completion, String> column, FontMetrics metrics) {
        return entries.stream().map(column).mapToInt(metrics::stringWidth).max().orElse(0);
    }

    private int column(int width) {
        return width == 0 ? 0 : width + 2 * character;
    }

    @Override
    public Component getListCellRendererComponent(
            JList<? extends Completion> list, Completion value, int index, boolean isSelected, boolean hasFocus) {
        return show(value, isSelected);
    }

    /**
     * Shows a completion.
     *
     * @param isSelected whether it is painted in the colours of a selection
     * @return this cell
     */
    public Component show(Completion value, boolean isSelected) {
        entry = value;
        selected = isSelected;
        getAccessibleContext()
                .setAccessibleName((value.text() + " " + value.values() + " " + value.explanation()).strip());
        return this;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D pen = (Graphics2D) graphics.create();
        useDesktopHints(pen);
        pen.setColor(UIManager.getColor(selected ? "List.selectionBackground" : "List.background"));
        pen.fillRect(0, 0, getWidth(), getHeight());
        Color text = UIManager.getColor(selected ? "List.selectionForeground" : "List.foreground");
        Color side = selected ? text : Palette.faint();
        int x = character;
        draw(pen, entry.text(), x, words, Font.BOLD, text);
        x += column(words);
        draw(pen, entry.values(), x, values, Font.PLAIN, selected ? text : Palette.command());
        x += column(values);
        draw(pen, entry.explanation(), x, getWidth() - character - x, Font.PLAIN, side);
        pen.dispose();
    }

    private static void useDesktopHints(Graphics2D pen) {
        pen.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        @Nullable Object hints = Toolkit.getDefaultToolkit().getDesktopProperty("awt.font.desktophints");
        if (hints instanceof Map<?, ?> map) {
            pen.addRenderingHints(map);
        }
    }

    private void draw(Graphics2D pen, String text, int x, int width, int style, Color color) {
        pen.setFont(getFont().deriveFont(style));
        pen.setColor(color);
        FontMetrics metrics = pen.getFontMetrics();
        String clipped = BasicGraphicsUtils.getClippedString(this, metrics, text, width);
        BasicGraphicsUtils.drawString(this, pen, clipped, x, character / 4f + metrics.getAscent());
    }
}
