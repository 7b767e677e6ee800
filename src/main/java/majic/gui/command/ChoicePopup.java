package majic.gui.command;

import java.awt.GraphicsConfiguration;
import java.awt.Insets;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JScrollPane;
import javax.swing.JWindow;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import javax.swing.text.BadLocationException;
import javax.swing.text.JTextComponent;
import majic.script.help.Completion;
import org.jspecify.annotations.Nullable;

/**
 * A list of choices below a text field; where the screen ends, above it and to the right of the newest messages. It
 * never takes the focus. Nothing is chosen until {@link #move} or {@link #choose}. Must be used on the event dispatch
 * thread.
 */
final class ChoicePopup {
    private static final int MOST_ROWS = 8;
    private static final int LEAST_ROWS = 4;
    private static final int GAP = 2;
    private static final int BESIDE = 10;

    /** Minimum width in characters of a list that is made narrower to leave the messages in view. */
    private static final int LEAST_WIDTH = 72;

    private final JTextComponent field;
    private final Consumer<Completion> clicked;
    private @Nullable ChoiceList list;
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
        this.clicked = clicked;
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
        ChoiceList shownList = list();
        shownList.show(choices, field.getFont());
        shownList.setVisibleRowCount(Math.min(rows(shownList.getFixedCellHeight()), choices.size()));
        JWindow shown = window(owner, shownList);
        shown.pack();
        place(shown, index, MOST_ROWS * shownList.getFixedCellHeight());
        shown.setVisible(true);
    }

    /**
     * Returns the list, which is created for the first entries, because the start of the program need not wait for it.
     */
    private ChoiceList list() {
        ChoiceList made = list;
        if (made == null) {
            made = new ChoiceList(clicked);
            list = made;
        }
        return made;
    }

    private JWindow window(Window owner, ChoiceList content) {
        JWindow made = window;
        if (made == null || made.getOwner() != owner) {
            made = new JWindow(owner);
            made.setName("choicesWindow");
            made.setType(Window.Type.POPUP);
            made.setFocusableWindowState(false);
            JScrollPane pane = new JScrollPane(content);
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

    private void place(Window shown, int index, int largestHeight) {
        Point corner = field.getLocationOnScreen();
        Rectangle screen = screen(field.getGraphicsConfiguration());
        int width = Math.min(shown.getWidth(), screen.width);
        int height = shown.getHeight();
        int x = corner.x + (int) characterX(index);
        int y = corner.y + field.getHeight() + GAP;
        if (y + height > screen.y + screen.height) {
            y = corner.y - GAP - height;
            x = Math.max(x, besideMessages(largestHeight));
            int right = Math.min(screen.x + screen.width, corner.x + field.getWidth());
            width = Math.min(width, Math.max(right - x, leastWidth()));
            x = Math.min(x, right - width);
        }
        shown.setBounds(Math.max(screen.x, Math.min(x, screen.x + screen.width - width)), y, width, height);
    }

    /** Returns where on the screen no text of the messages that the largest list would cover is any more. */
    private int besideMessages(int largestHeight) {
        MessageArea above = messages;
        if (above == null || !above.isShowing()) {
            return 0;
        }
        return above.getLocationOnScreen().x + above.textEnd(largestHeight) + BESIDE;
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
        if (!isShowing()) {
            return false;
        }
        int last = list().lastChoice();
        int index = (chosen ? list().getSelectedIndex() : -1) + step;
        if (last < 0 || index < -1) {
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
        list().select(index);
    }

    /** Returns the chosen entry. */
    Optional<Completion> chosen() {
        return isShowing() && chosen ? Optional.ofNullable(list().getSelectedValue()) : Optional.empty();
    }
}
