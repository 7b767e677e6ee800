package majic.gui.command;

import java.awt.GraphicsConfiguration;
import java.awt.Insets;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.DefaultListModel;
import javax.swing.JList;
import javax.swing.JScrollPane;
import javax.swing.JWindow;
import javax.swing.ListSelectionModel;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import javax.swing.text.BadLocationException;
import javax.swing.text.JTextComponent;
import majic.gui.kit.CompletionCell;
import majic.script.help.Completion;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * A list of choices below a text field; where the screen ends, above it and to the right of the newest messages. It never
 * takes the focus. Nothing is chosen until {@link #move} or {@link #choose}. Must be used on the event dispatch thread.
 */
final class ChoicePopup {
    private static final Texts TEXTS = Texts.of(ChoicePopup.class);
    private static final int MOST_ROWS = 8;
    private static final int LEAST_ROWS = 4;
    private static final int GAP = 2;
    private static final int BESIDE = 10;

    /** Minimum width in characters of a list that is made narrower to leave the messages in view. */
    private static final int LEAST_WIDTH = 45;

    private final JTextComponent field;
    private final DefaultListModel<Completion> entries = new DefaultListModel<>();
    private final JList<Completion> list = new JList<>(entries) {
        private static final long serialVersionUID = 1L;

        /** Returns true: a list that is made narrower shortens the explanations. */
        @Override
        public boolean getScrollableTracksViewportWidth() {
            return true;
        }
    };
    private final CompletionCell cell = new CompletionCell();
    private @Nullable MessageArea messages;
    private @Nullable JWindow window;
    private boolean chosen;

    /**
     * Creates a hidden popup.
     *
     * @param clicked receives the entry that is clicked
     */
    ChoicePopup(JTextComponent field, Consumer<Completion> clicked) {
        this.field = field;
        list.setName("choices");
        list.getAccessibleContext().setAccessibleName(TEXTS.get("completions"));
        list.setFocusable(false);
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.setCellRenderer(cell);
        list.addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent event) {
                int index = list.locationToIndex(event.getPoint());
                if (index >= 0 && !entries.get(index).isHint()) {
                    clicked.accept(entries.get(index));
                }
            }
        });
    }

    /** Keeps the newest messages in view while the list is above the field. */
    void leaveInView(MessageArea newest) {
        messages = newest;
    }

    boolean isShowing() {
        return window != null && window.isVisible();
    }

    /**
     * Shows entries with none of them chosen; hides the popup if there are none.
     *
     * @param index the character of the field under which they begin
     */
    void show(int index, List<Completion> choices) {
        Window owner = SwingUtilities.getWindowAncestor(field);
        if (choices.isEmpty() || owner == null || !field.isShowing()) {
            hide();
            return;
        }
        chosen = false;
        entries.clear();
        entries.addAll(choices);
        cell.measure(choices, field.getFont());
        list.setFixedCellHeight(cell.getPreferredSize().height);
        list.setFixedCellWidth(cell.getPreferredSize().width);
        list.setVisibleRowCount(Math.min(rows(list.getFixedCellHeight()), choices.size()));
        list.clearSelection();
        list.ensureIndexIsVisible(0);
        JWindow shown = window(owner);
        shown.pack();
        place(shown, index);
        shown.setVisible(true);
    }

    private JWindow window(Window owner) {
        JWindow made = window;
        if (made == null || made.getOwner() != owner) {
            made = new JWindow(owner);
            made.setName("choicesWindow");
            made.setType(Window.Type.POPUP);
            made.setFocusableWindowState(false);
            JScrollPane pane = new JScrollPane(list);
            pane.setHorizontalScrollBarPolicy(JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
            pane.setBorder(BorderFactory.createLineBorder(UIManager.getColor("Component.borderColor")));
            made.setContentPane(pane);
            window = made;
        }
        return made;
    }

    /** Returns how many rows the list has at most: no more than cover the messages. */
    private int rows(int rowHeight) {
        MessageArea above = messages;
        return above == null ? MOST_ROWS : Math.max(LEAST_ROWS, Math.min(MOST_ROWS, above.getHeight() / rowHeight));
    }

    private void place(Window shown, int index) {
        Point corner = field.getLocationOnScreen();
        Rectangle screen = screen(field.getGraphicsConfiguration());
        int width = Math.min(shown.getWidth(), screen.width);
        int height = shown.getHeight();
        int x = corner.x + (int) characterX(index);
        int y = corner.y + field.getHeight() + GAP;
        if (y + height > screen.y + screen.height) {
            y = corner.y - GAP - height;
            x = Math.max(x, besideMessages());
            int right = Math.min(screen.x + screen.width, corner.x + field.getWidth());
            width = Math.min(width, Math.max(right - x, leastWidth()));
            x = Math.min(x, right - width);
        }
        shown.setBounds(Math.max(screen.x, Math.min(x, screen.x + screen.width - width)), y, width, height);
    }

    /** Returns where on the screen no text of the messages that the largest list would cover is any more. */
    private int besideMessages() {
        MessageArea above = messages;
        if (above == null || !above.isShowing()) {
            return 0;
        }
        return above.getLocationOnScreen().x + above.textEnd(MOST_ROWS * list.getFixedCellHeight()) + BESIDE;
    }

    private int leastWidth() {
        return LEAST_WIDTH * field.getFontMetrics(field.getFont()).charWidth('m');
    }

    private double characterX(int index) {
        try {
            Rectangle2D place =
                    field.modelToView2D(Math.min(index, field.getDocument().getLength()));
            return place == null ? 0 : place.getX();
        } catch (BadLocationException e) {
            return 0;
        }
    }

    private static Rectangle screen(GraphicsConfiguration configuration) {
        Rectangle bounds = configuration.getBounds();
        Insets bars = Toolkit.getDefaultToolkit().getScreenInsets(configuration);
        return new Rectangle(
                bounds.x + bars.left,
                bounds.y + bars.top,
                bounds.width - bars.left - bars.right,
                bounds.height - bars.top - bars.bottom);
    }

    void hide() {
        if (window != null) {
            window.setVisible(false);
        }
        chosen = false;
    }

    /**
     * Chooses the next or the previous entry; in front of the first one none is chosen.
     *
     * @param step 1 or -1
     * @return false if there is none to choose
     */
    boolean move(int step) {
        int last = entries.size() - 1;
        while (last >= 0 && entries.get(last).isHint()) {
            last--;
        }
        int index = (chosen ? list.getSelectedIndex() : -1) + step;
        if (!isShowing() || last < 0 || index < -1) {
            return false;
        }
        choose(Math.min(index, last));
        return true;
    }

    /** Chooses an entry; -1 chooses none. */
    void choose(int index) {
        highlight(index);
        chosen = index >= 0;
    }

    /** Shows which entry stands in the field, without choosing it. */
    void highlight(int index) {
        chosen = false;
        list.clearSelection();
        if (index >= 0 && index < entries.size()) {
            list.setSelectedIndex(index);
            list.ensureIndexIsVisible(index);
        }
    }

    /** Returns the chosen entry. */
    Optional<Completion> chosen() {
        return isShowing() && chosen ? Optional.ofNullable(list.getSelectedValue()) : Optional.empty();
    }
}
