package majic.panel;

import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.Reading;
import majic.time.WaitPolicy;

/**
 * Shows a robot's readings by name, in as many columns as fit, the most useful first; rows that do not fit are left
 * out, none is cut. All values are read from one source, such as the robot or a snapshot of it. Must be used on the
 * event dispatch thread.
 *
 * @param <S> the source
 */
public final class ReadingsPanel<S> extends JPanel {
    private static final long serialVersionUID = 1;
    private static final int LEAST_ROWS = 3;

    /** Reserve in pixels: text may be slightly wider than measured on a screen of another scale. */
    private static final int SLACK = 4;

    /** Text for a missing value. */
    public static final String NONE = "–";

    private final String longestValue;
    private final transient List<Function<? super S, String>> texts = new ArrayList<>();
    private final transient List<JLabel> names = new ArrayList<>();
    private final transient List<JLabel> values = new ArrayList<>();
    private final transient ReadingKeys keys = new ReadingKeys();
    private int paired;
    private String longestOfPair = "";

    /**
     * Creates a panel without rows.
     *
     * @param longestValue a text as wide as the widest value, which each column must hold
     */
    public ReadingsPanel(String longestValue) {
        super(null);
        this.longestValue = longestValue;
        setOpaque(false);
    }

    /**
     * Creates a panel that shows parameters of a robot; without a connection it shows the last values, which
     * {@link #show} greys then. One that is unknown, or that this robot does not have, shows {@link #NONE}. They are
     * read on the event thread, which waits for nothing.
     *
     * @param longestValue a text as wide as the widest value
     * @param parameters their names in the order of the rows
     */
    public static ReadingsPanel<MajicBot> ofParameters(String longestValue, List<String> parameters) {
        ReadingsPanel<MajicBot> panel = new ReadingsPanel<>(longestValue);
        parameters.forEach(name -> panel.with(name, bot -> text(bot, name)));
        return panel;
    }

    private static String text(MajicBot bot, String name) {
        String[] text = {NONE};
        WaitPolicy.without(() -> {
            try {
                Reading reading = bot.reading(name);
                text[0] = ReadingText.of(bot.isConnected() ? reading.value() : reading.last());
            } catch (BotException e) {
                text[0] = NONE;
            }
        });
        return text[0];
    }

    /**
     * Adds a row below the others. Its label is the name in plain words; the tool tips show the name itself. A click on
     * the value plots the parameter.
     *
     * @param name of the reading; the parameter's, if there is one
     * @param text formats the value
     * @return this panel
     */
    public ReadingsPanel<S> with(String name, Function<? super S, String> text) {
        return with(name, List.of(name), text);
    }

    /**
     * Adds a row below the others, for a reading that has another name than its parameter, or several parameters.
     *
     * @param name of the reading
     * @param parameters names of the parameters that a click on the value plots
     * @param text formats the value
     * @return this panel
     */
    public ReadingsPanel<S> with(String name, List<String> parameters, Function<? super S, String> text) {
        JLabel value = new ValueLabel();
        value.setName(name);
        value.setBorder(BorderFactory.createEmptyBorder(0, 0, 0, SLACK / 2));
        value.setToolTipText(ReadingText.tip(name));
        JLabel label = new JLabel(ReadingText.label(name));
        label.setToolTipText(ReadingText.tip(name));
        names.add(label);
        keys.add(value, parameters);
        PlotLink.install(value, parameters);
        values.add(value);
        texts.add(text);
        add(names.get(names.size() - 1));
        add(value);
        return this;
    }

    /**
     * Sets the labels of the rows added so far, which are the names in plain English words otherwise.
     *
     * @param labels returns the label of a reading, by its name, in the user's language
     * @return this panel
     */
    public ReadingsPanel<S> labelled(UnaryOperator<String> labels) {
        for (int index = 0; index < names.size(); index++) {
            names.get(index).setText(labels.apply(values.get(index).getName()));
        }
        return this;
    }

    /**
     * Shows the first readings two in a row where there is one column wide enough for that, so that they need half the
     * height. Their labels should be short.
     *
     * @param count even; not more than there are rows
     * @param longest a text as wide as the widest value of these
     * @return this panel
     */
    public ReadingsPanel<S> paired(int count, String longest) {
        paired = count;
        longestOfPair = longest;
        return this;
    }

    /**
     * Shows the values, unless there is no room for the panel.
     *
     * @param source the source of the values
     * @param current whether they are current; older ones are greyed
     */
    public void show(S source, boolean current) {
        for (int index = 0; index < texts.size() && isVisible(); index++) {
            values.get(index).setText(texts.get(index).apply(source));
            values.get(index).setEnabled(current);
        }
    }

    /** Needs no new layout for another text, since its place does not depend on it. */
    private static final class ValueLabel extends JLabel {
        private static final long serialVersionUID = 1;

        ValueLabel() {
            super(NONE, SwingConstants.TRAILING);
        }

        @Override
        public void revalidate() {}
    }

    /** Lets the keys reach the values that can be plotted where the panel is. */
    @Override
    public void addNotify() {
        super.addNotify();
        keys.update();
    }

    /** Its size does not depend on the values shown, so a new value needs no new layout of the window. */
    @Override
    public boolean isValidateRoot() {
        return true;
    }

    /** Returns its height within an area of this size; 0 if the area is too small for it. */
    int heightWithin(int width, int height) {
        int least = rowHeight() * (pairsIn(width) > 0 ? pairsIn(width) : LEAST_ROWS);
        return width < columnWidth() || height < least ? 0 : Math.min(height - height % rowHeight(), heightIn(width));
    }

    /** Returns whether an area shows all readings that can stand two in a row; if none can, whether it shows any. */
    boolean showsImportant(int width, int height) {
        int rows = heightWithin(width, height) / rowHeight();
        return rows > 0 && (pairsIn(width) > 0 || rows * columnsIn(width) >= paired);
    }

    /** Sets its bounds; hides it if the height is 0. */
    void place(int x, int y, int width, int height) {
        setVisible(height > 0);
        setBounds(x, y, width, height);
    }

    @Override
    public void doLayout() {
        int rows = Math.max(1, getHeight() / rowHeight());
        int columns = columnsIn(getWidth());
        int filled = Math.min(rows, rowsIn(getWidth()));
        int width = widthOfEach(getWidth());
        int pairs = pairsIn(getWidth());
        for (int index = 0; index < 2 * pairs; index++) {
            int half = (width - gap() / 2) / 2;
            Rectangle cell = new Rectangle(index % 2 * (width - half), index / 2 * rowHeight(), half, rowHeight());
            place(index, cell, nameWidth(2 * pairs), index / 2 < filled);
        }
        for (int index = 2 * pairs; index < names.size(); index++) {
            int cell = index - pairs;
            Rectangle row =
                    new Rectangle(cell / filled * (width + gap()), cell % filled * rowHeight(), width, rowHeight());
            place(index, row, nameWidth(names.size()), cell / filled < columns);
        }
    }

    private void place(int index, Rectangle row, int nameWidth, boolean fits) {
        names.get(index).setVisible(fits);
        values.get(index).setVisible(fits);
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

    /** Returns the height needed to show every row. */
    private int heightIn(int width) {
        return rowHeight() * rowsIn(width);
    }

    private int rowsIn(int width) {
        return ceil(names.size(), columnsIn(width)) - pairsIn(width);
    }

    /** Returns the number of rows with two readings. */
    private int pairsIn(int width) {
        return columnsIn(width) == 1 && pairWidth() <= width ? paired / 2 : 0;
    }

    /** Returns the width at which the first readings stand two in a row; 0 if they never do. */
    int pairWidth() {
        int each = nameWidth(paired) + metrics().stringWidth(longestOfPair) + 2 * SLACK;
        return paired == 0 ? 0 : 2 * each + gap() / 2;
    }

    /** Returns the width of a column. */
    private int widthOfEach(int width) {
        int columns = columnsIn(width);
        return Math.max(columnWidth(), (width - (columns - 1) * gap()) / columns);
    }

    private int columnsIn(int width) {
        return Math.max(1, (width + gap()) / (columnWidth() + gap()));
    }

    /** Returns the gap in pixels between two columns, and between readings and drawing. */
    int gap() {
        return rowHeight();
    }

    private int columnWidth() {
        FontMetrics metrics = metrics();
        return nameWidth(names.size()) + gap() / 2 + metrics.stringWidth(longestValue) + SLACK;
    }

    /** Returns the width of the widest of the first labels. */
    private int nameWidth(int count) {
        return names.stream()
                        .limit(count)
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
