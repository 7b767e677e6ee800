package majic.gui.completion;

import java.awt.Component;
import java.awt.GraphicsConfiguration;
import java.awt.Insets;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.HierarchyBoundsListener;
import java.awt.event.HierarchyEvent;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.JWindow;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import javax.swing.text.BadLocationException;
import javax.swing.text.JTextComponent;
import majic.script.help.Completion;
import org.jspecify.annotations.Nullable;

/**
 * A list of choices below a text field or a line of a text; where the screen ends, above it. It never takes the focus.
 * Nothing is chosen until {@link #move} or {@link #choose}. Must be used on the event dispatch thread.
 */
public final class ChoicePopup {
    private static final int MOST_ROWS = 8;
    private static final int LEAST_ROWS = 4;
    private static final int GAP = 2;
    private static final int BESIDE = 10;

    /** Minimum width in characters of a list that is made narrower to leave a text in view. */
    private static final int LEAST_WIDTH = 72;

    private final JTextComponent field;
    private final Consumer<Completion> clicked;
    private @Nullable ChoiceList list;
    private @Nullable TextInView inView;
    private @Nullable JWindow window;
    private Runnable changed = () -> {};
    private int index;
    private boolean chosen;

    /** A text above the field of which the lowest lines stay in view beside the list. */
    public interface TextInView {
        /** Returns the component that shows the text. */
        Component component();

        /**
         * Returns where the lowest lines in view end, in pixels from the left of the component.
         *
         * @param height the height of these lines in pixels; more than the component has for all lines in view
         */
        int textEnd(int height);
    }

    /**
     * Creates a hidden popup.
     *
     * @param clicked receives the entry that is clicked
     */
    ChoicePopup(JTextComponent field, Consumer<Completion> clicked) {
        this.field = field;
        this.clicked = clicked;
        field.addHierarchyBoundsListener(new HierarchyBoundsListener() {
            @Override
            public void ancestorMoved(HierarchyEvent event) {
                follow();
            }

            @Override
            public void ancestorResized(HierarchyEvent event) {
                follow();
            }
        });
        field.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentMoved(ComponentEvent event) {
                follow();
            }
        });
    }

    /** Keeps the end of a text in view while the list is above the field. */
    public void leaveInView(TextInView text) {
        inView = text;
    }

    /** Sets what runs whenever the list was opened or closed. */
    public void onChange(Runnable listener) {
        changed = listener;
    }

    /** Returns whether the list is open. */
    public boolean isShowing() {
        return window != null && window.isVisible();
    }

    /**
     * Shows entries with none of them chosen; hides the popup if there are none.
     *
     * @param at the character of the field under which they begin
     */
    public void show(int at, List<Completion> choices) {
        Window owner = SwingUtilities.getWindowAncestor(field);
        if (choices.isEmpty() || owner == null || !field.isShowing()) {
            hide();
            return;
        }
        chosen = false;
        index = at;
        ChoiceList shownList = list();
        shownList.show(choices, field.getFont());
        shownList.setVisibleRowCount(Math.min(rows(shownList.getFixedCellHeight()), choices.size()));
        JWindow shown = window(owner, shownList);
        place(shown);
        setVisible(shown, true);
    }

    private void setVisible(JWindow list, boolean visible) {
        if (list.isVisible() != visible) {
            list.setVisible(visible);
            changed.run();
        }
    }

    /** Moves the open list with its field. */
    private void follow() {
        JWindow shown = window;
        if (shown != null && isShowing() && field.isShowing()) {
            place(shown);
        }
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

    /** Returns how many rows the list has at most: no more than cover the text that stays in view. */
    private int rows(int rowHeight) {
        TextInView above = inView;
        int height = above == null ? Integer.MAX_VALUE : above.component().getHeight();
        return Math.max(LEAST_ROWS, Math.min(MOST_ROWS, height / rowHeight));
    }

    private void place(Window shown) {
        shown.pack();
        Point corner = field.getLocationOnScreen();
        Rectangle screen = screen(field.getGraphicsConfiguration());
        Rectangle line = line();
        int width = Math.min(shown.getWidth(), screen.width);
        int height = shown.getHeight();
        int x = corner.x + line.x;
        int y = corner.y + line.y + line.height + GAP;
        if (y + height > screen.y + screen.height) {
            y = corner.y + line.y - GAP - height;
            x = Math.max(x, besideText());
            int right = Math.min(screen.x + screen.width, corner.x + field.getWidth());
            width = Math.min(width, Math.max(right - x, leastWidth()));
            x = Math.min(x, right - width);
        }
        shown.setBounds(Math.max(screen.x, Math.min(x, screen.x + screen.width - width)), y, width, height);
    }

    /** Returns where on the screen no text that stays in view, and that the largest list would cover, is any more. */
    private int besideText() {
        TextInView above = inView;
        if (above == null || !above.component().isShowing()) {
            return 0;
        }
        int largestHeight = MOST_ROWS * list().getFixedCellHeight();
        return above.component().getLocationOnScreen().x + above.textEnd(largestHeight) + BESIDE;
    }

    private int leastWidth() {
        return LEAST_WIDTH * field.getFontMetrics(field.getFont()).charWidth('m');
    }

    /** Returns the place of the character from which on the choices begin, with the height of its line or field. */
    private Rectangle line() {
        try {
            Rectangle2D place =
                    field.modelToView2D(Math.min(index, field.getDocument().getLength()));
            Rectangle found = place == null ? new Rectangle() : place.getBounds();
            return field instanceof JTextField ? new Rectangle(found.x, 0, 0, field.getHeight()) : found;
        } catch (BadLocationException e) {
            throw new IllegalStateException("the place is in the text", e);
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

    /** Closes the list. */
    public void hide() {
        chosen = false;
        if (window != null) {
            setVisible(window, false);
        }
    }

    /**
     * Chooses the next or the previous entry; in front of the first one none is chosen.
     *
     * @param step 1 or -1
     * @return false if there is none to choose
     */
    public boolean move(int step) {
        if (!isShowing()) {
            return false;
        }
        int last = list().lastChoice();
        int entry = (chosen ? list().getSelectedIndex() : -1) + step;
        if (last < 0 || entry < -1) {
            return false;
        }
        choose(Math.min(entry, last));
        return true;
    }

    /** Chooses an entry; -1 chooses none. */
    public void choose(int entry) {
        highlight(entry);
        chosen = entry >= 0;
    }

    /** Shows which entry stands in the field, without choosing it. */
    public void highlight(int entry) {
        chosen = false;
        list().select(entry);
    }

    /** Returns the chosen entry. */
    public Optional<Completion> chosen() {
        return isShowing() && chosen ? Optional.ofNullable(list().getSelectedValue()) : Optional.empty();
    }
}
