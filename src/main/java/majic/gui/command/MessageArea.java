package majic.gui.command;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.time.LocalTime;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.swing.JScrollBar;
import javax.swing.JScrollPane;
import javax.swing.UIManager;
import javax.swing.text.BadLocationException;
import javax.swing.text.Position;
import majic.gui.completion.ChoicePopup;
import majic.log.Line;
import majic.log.SessionListener;
import majic.panel.RefreshTicks;
import org.jspecify.annotations.Nullable;

/**
 * Shows the lines of the session that a filter accepts: the newest one at the bottom, in view unless the area is
 * scrolled up. Lines may arrive from any thread and at any rate; they are shown ten times a second, and the oldest are
 * removed.
 */
public final class MessageArea extends JScrollPane implements SessionListener, ChoicePopup.TextInView {
    private static final long serialVersionUID = 1L;

    private final transient List<Message> waiting = new ArrayList<>();
    private final transient MessageLog messages = new MessageLog();
    private final transient Runnable update = this::showWaiting;
    private final transient Supplier<MessageText> newText;
    private @Nullable MessageText made;
    private transient MessageDocument document = new MessageDocument(false);
    private transient MessageFilter filter = MessageFilter.EVERYTHING;
    private transient Runnable changed = () -> {};
    private boolean withTimes;
    private transient Unseen unseen = Unseen.NONE;

    /**
     * The messages that have arrived below the lines in view since the area was scrolled up. Immutable.
     *
     * @param lines their number
     * @param alarm whether one of them is an alarm
     */
    record Unseen(int lines, boolean alarm) {
        static final Unseen NONE = new Unseen(0, false);

        Unseen and(List<Message> added) {
            boolean alarms = added.stream().anyMatch(message -> message.line().kind() == Line.Kind.ALARM);
            return new Unseen(lines + added.size(), alarm || alarms);
        }
    }

    /**
     * Creates an empty area, without a text as long as there is no message, because making it delays the window.
     *
     * @param newText makes the text
     */
    MessageArea(Supplier<MessageText> newText) {
        this.newText = newText;
        setName("messageArea");
        setPreferredSize(UIScale.scale(new Dimension(600, 150)));
        setMinimumSize(UIScale.scale(new Dimension(200, 70)));
        getVerticalScrollBar().addAdjustmentListener(event -> scrolled());
    }

    /** Returns the text, which is made at the first call. */
    MessageText text() {
        MessageText text = made;
        if (text == null) {
            text = newText.get();
            made = text;
            text.setDocument(document);
            setViewportView(text);
            validate();
        }
        return text;
    }

    MessageFilter filter() {
        return filter;
    }

    boolean hasTimes() {
        return withTimes;
    }

    Unseen unseen() {
        return unseen;
    }

    /** Sets what runs after messages were added, removed or scrolled to, on the event dispatch thread. */
    void onChange(Runnable listener) {
        changed = listener;
    }

    /** Queues a line for display; callable from any thread. */
    @Override
    public void line(Line line) {
        synchronized (waiting) {
            if (waiting.size() == MessageLog.MOST_KEPT) {
                waiting.subList(0, MessageDocument.MOST_LINES).clear();
            }
            waiting.add(new Message(LocalTime.now(), line));
        }
        RefreshTicks.once(update);
    }

    /** Shows the messages that a filter accepts, among them those that were hidden. */
    void show(MessageFilter accepted) {
        filter = accepted;
        showKept();
    }

    void showTimes(boolean shown) {
        if (shown != withTimes) {
            withTimes = shown;
            showKept();
        }
    }

    /** Removes all messages. */
    void clear() {
        messages.clear();
        showKept();
    }

    /** Returns the numbers of the robots with which messages begin. */
    Set<Integer> robots() {
        Set<Integer> robots = new TreeSet<>();
        messages.all().forEach(message -> robots.addAll(message.robots()));
        return robots;
    }

    /** Returns the message at a place of the text; the document must not be empty. */
    Message messageAt(int offset) {
        return document.messageAt(offset);
    }

    boolean isEmpty() {
        return document.isEmpty();
    }

    /** Updates the colours for the look and feel. */
    @Override
    public void updateUI() {
        super.updateUI();
        getViewport().setBackground(UIManager.getColor("TextPane.inactiveBackground"));
        if (document != null) {
            document.recolour();
        }
    }

    /**
     * Keeps the newest line in view when the size changes: in the same event, so that it does not scroll back an area
     * that is scrolled up meanwhile.
     */
    @Override
    protected void validateTree() {
        boolean follow = made != null && isAtEnd();
        super.validateTree();
        if (follow) {
            toEnd();
        }
    }

    private void showWaiting() {
        List<Message> arrived;
        synchronized (waiting) {
            arrived = List.copyOf(waiting);
            waiting.clear();
        }
        text();
        List<Message> joined = new ArrayList<>();
        List<Message> added = accepted(messages.add(arrived, (old, present) -> {
            if (filter.accepts(old)) {
                document.replace(old, present);
            } else {
                joined.add(present);
            }
        }));
        List<Message> shown =
                Stream.concat(accepted(joined).stream(), added.stream()).toList();
        if (isAtEnd()) {
            document.append(shown);
            showNewest();
        } else {
            unseen = unseen.and(shown);
            appendAbove(shown);
        }
        changed.run();
    }

    private List<Message> accepted(Collection<Message> candidates) {
        return candidates.stream().filter(filter::accepts).toList();
    }

    /** Appends messages; keeps the text in view at its place although older lines are removed above it. */
    private void appendAbove(List<Message> added) {
        Point view = getViewport().getViewPosition();
        try {
            MessageText text = text();
            Position top = document.createPosition(text.viewToModel2D(view));
            double before = y(top);
            document.append(added);
            validate();
            double moved = y(top) - before;
            getViewport().setViewPosition(new Point(view.x, (int) Math.max(0, Math.round(view.y + moved))));
        } catch (BadLocationException e) {
            throw new IllegalStateException("the place is in the text", e);
        }
    }

    @Override
    public Component component() {
        return this;
    }

    @Override
    public int textEnd(int height) {
        MessageText text = text();
        Rectangle view = getViewport().getViewRect();
        int line = text.getFontMetrics(text.getFont()).getHeight();
        double end = 0;
        try {
            for (int y = view.y + view.height - 1; y >= view.y + Math.max(0, view.height - height); y -= line) {
                Rectangle2D last = text.modelToView2D(text.viewToModel2D(new Point(view.x + view.width, y)));
                end = Math.max(end, last == null ? 0 : last.getMaxX());
            }
        } catch (BadLocationException e) {
            throw new IllegalStateException("the place is in the text", e);
        }
        return getViewport().getX() + (int) Math.ceil(end) - view.x;
    }

    private double y(Position place) throws BadLocationException {
        Rectangle2D character = text().modelToView2D(place.getOffset());
        return character == null ? 0 : character.getY();
    }

    private void showKept() {
        document = new MessageDocument(withTimes);
        document.append(accepted(messages.all()));
        text().setDocument(document);
        unseen = Unseen.NONE;
        showNewest();
        changed.run();
    }

    private void scrolled() {
        if (unseen.lines() > 0 && isAtEnd()) {
            unseen = Unseen.NONE;
            changed.run();
        }
    }

    /** Scrolls to the newest message, which stays in view. */
    void showNewest() {
        if (made != null) {
            validate();
            toEnd();
        }
    }

    private boolean isAtEnd() {
        JScrollBar bar = getVerticalScrollBar();
        return bar.getValue() + bar.getVisibleAmount() >= bar.getMaximum() - 4;
    }

    private void toEnd() {
        JScrollBar bar = getVerticalScrollBar();
        bar.setValue(bar.getMaximum());
    }
}
