package majic.panel;

import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;

/** Names and values in columns, the most useful first: what finds no room is left out, nothing is cut. For the event thread. */
public class NumbersPanel extends JPanel {
    private static final long serialVersionUID = 1;
    private static final int LEAST_ROWS = 3;

    /** Figures far from their names are hard to read along. */
    private static final double WIDEST = 1.4;

    /** Text may come out a little wider than measured on a screen of another scale. */
    private static final int SLACK = 4;

    private final transient List<JLabel> names = new ArrayList<>();
    private final transient List<JLabel> values = new ArrayList<>();
    private final transient List<String> longest = new ArrayList<>();

    /** Makes it without a row. */
    public NumbersPanel() {
        super(null);
        setOpaque(false);
    }

    /**
     * Adds a row below the others.
     *
     * @param name of the reading, if there is one the parameter's
     * @param longestValue what the column must hold
     * @return where the value is shown
     */
    public final JLabel row(String name, String longestValue) {
        JLabel value = new JLabel("–", SwingConstants.TRAILING);
        value.setName(name);
        names.add(new JLabel(name));
        values.add(value);
        longest.add(longestValue);
        add(names.get(names.size() - 1));
        add(value);
        return value;
    }

    /** How high it is at most in a room, 0 if that is too little to be worth it. */
    final int heightWithin(int width, int height) {
        Dimension least = getMinimumSize();
        return width < least.width || height < least.height ? 0 : Math.min(height, heightIn(width));
    }

    /** Takes its place, or goes if it has no height. */
    final void place(int x, int y, int width, int height) {
        setVisible(height > 0);
        setBounds(x, y, width, height);
    }

    @Override
    public void doLayout() {
        int rows = Math.max(1, getHeight() / rowHeight());
        int columns = columnsIn(getWidth());
        int filled = Math.min(rows, ceil(names.size(), columns));
        int room = (getWidth() - (columns - 1) * gap()) / columns;
        int width = Math.max(columnWidth(), (int) Math.min(room, WIDEST * columnWidth()));
        for (int index = 0; index < names.size(); index++) {
            boolean fits = index / filled < columns;
            names.get(index).setVisible(fits);
            values.get(index).setVisible(fits);
            place(
                    index,
                    new Rectangle(index / filled * (width + gap()), index % filled * rowHeight(), width, rowHeight()));
        }
    }

    private void place(int index, Rectangle row) {
        int nameWidth = nameWidth();
        names.get(index).setBounds(row.x, row.y, nameWidth, row.height);
        values.get(index).setBounds(row.x + nameWidth, row.y, row.width - nameWidth, row.height);
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(columnWidth(), LEAST_ROWS * rowHeight());
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(columnWidth(), names.size() * rowHeight());
    }

    /** How high it must be to show every row. */
    private int heightIn(int width) {
        return rowHeight() * ceil(names.size(), columnsIn(width));
    }

    private int columnsIn(int width) {
        return Math.max(1, (width + gap()) / (columnWidth() + gap()));
    }

    /** Between two columns, and between readings and drawing. */
    final int gap() {
        return rowHeight();
    }

    private int columnWidth() {
        FontMetrics metrics = metrics();
        int valueWidth = longest.stream().mapToInt(metrics::stringWidth).max().orElse(0);
        return nameWidth() + gap() / 2 + valueWidth + SLACK;
    }

    private int nameWidth() {
        return names.stream()
                        .mapToInt(name -> name.getPreferredSize().width)
                        .max()
                        .orElse(0)
                + SLACK;
    }

    private int rowHeight() {
        return metrics().getHeight() + 2;
    }

    private FontMetrics metrics() {
        return getFontMetrics(names.isEmpty() ? getFont() : names.get(0).getFont());
    }

    private static int ceil(int count, int parts) {
        return (count + parts - 1) / parts;
    }
}
