package majic.gui.command;

import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JScrollBar;
import javax.swing.JScrollPane;
import javax.swing.JTextPane;
import majic.gui.kit.EventThread;
import majic.gui.kit.UpdateThrottle;
import majic.log.Line;
import majic.log.SessionListener;

/**
 * Shows the lines of the session: the newest one at the bottom, in view unless the area is scrolled up. Lines may
 * arrive from any thread and at any rate; they are shown ten times a second, and the oldest are removed.
 */
public final class MessageArea extends JScrollPane implements SessionListener {
    private static final long serialVersionUID = 1L;
    private static final int MOST_WAITING = 2 * MessageDocument.MOST_LINES;

    private final transient List<Line> waiting = new ArrayList<>();
    private final transient UpdateThrottle throttle = new UpdateThrottle(this::showWaiting);
    private final transient MessageDocument document = new MessageDocument();
    private final JTextPane text = new JTextPane();

    MessageArea() {
        text.setEditorKit(new WrappingKit());
        text.setDocument(document);
        setViewportView(text);
        setName("messageArea");
        text.setName("messages");
        text.setEditable(false);
        text.setBorder(BorderFactory.createEmptyBorder(6, 8, 6, 8));
        text.putClientProperty("FlatLaf.styleClass", "monospaced");
        text.getAccessibleContext().setAccessibleName("Messages");
        setPreferredSize(new Dimension(600, 150));
        setMinimumSize(new Dimension(200, 70));
    }

    /** Queues a line for display; callable from any thread. */
    @Override
    public void line(Line line) {
        synchronized (waiting) {
            if (waiting.size() == MOST_WAITING) {
                waiting.subList(0, MessageDocument.MOST_LINES).clear();
            }
            waiting.add(line);
        }
        throttle.changed();
    }

    /** Updates the colours for the look and feel. */
    @Override
    public void updateUI() {
        super.updateUI();
        if (document != null) {
            document.recolour();
        }
    }

    /** Keeps the newest line in view when the size changes. */
    @Override
    public void doLayout() {
        boolean follow = isAtEnd();
        super.doLayout();
        if (follow) {
            EventThread.later(this::toEnd);
        }
    }

    private void showWaiting() {
        List<Line> lines;
        synchronized (waiting) {
            lines = List.copyOf(waiting);
            waiting.clear();
        }
        boolean follow = isAtEnd();
        document.append(lines);
        if (follow) {
            EventThread.later(this::toEnd);
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
