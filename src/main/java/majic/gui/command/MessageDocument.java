package majic.gui.command;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import javax.swing.text.AttributeSet;
import javax.swing.text.BadLocationException;
import javax.swing.text.DefaultStyledDocument;
import javax.swing.text.Element;
import javax.swing.text.SimpleAttributeSet;
import javax.swing.text.Style;
import javax.swing.text.StyleConstants;
import javax.swing.text.StyleContext;
import majic.gui.kit.Palette;
import majic.log.Line;

/**
 * The text of the message area: a limited number of messages with one line each, marked by its kind with a sign in
 * front and a colour. Must be used on the event dispatch thread.
 */
final class MessageDocument extends DefaultStyledDocument {
    static final int MOST_LINES = 2000;
    private static final long serialVersionUID = 1L;

    private final boolean withTimes;
    private final transient List<Message> messages = new ArrayList<>();

    /**
     * Creates an empty document.
     *
     * @param withTimes whether each line begins with the time of day
     */
    MessageDocument(boolean withTimes) {
        this.withTimes = withTimes;
        for (Line.Kind kind : Line.Kind.values()) {
            Style style = addStyle(kind.name(), getStyle(StyleContext.DEFAULT_STYLE));
            StyleConstants.setBold(style, kind == Line.Kind.COMMAND || kind == Line.Kind.ALARM);
        }
        recolour();
    }

    /** Updates the colours for the present look and feel. */
    void recolour() {
        for (Line.Kind kind : Line.Kind.values()) {
            StyleConstants.setForeground(getStyle(kind.name()), color(kind));
        }
        StyleConstants.setBackground(getStyle(Line.Kind.ALARM.name()), Palette.error());
    }

    /** Returns the message at a place of the text; the last one behind the end. The document must not be empty. */
    Message messageAt(int offset) {
        return messages.get(
                Math.min(messages.size() - 1, getDefaultRootElement().getElementIndex(offset)));
    }

    boolean isEmpty() {
        return messages.isEmpty();
    }

    /** Appends messages and removes the oldest ones; those that would be removed at once are left out. */
    void append(List<Message> added) {
        List<Message> newest = added.subList(Math.max(0, added.size() - MOST_LINES), added.size());
        try {
            for (int from = 0, to; from < newest.size(); from = to) {
                to = endOfRun(newest, from);
                appendRun(newest.subList(from, to));
            }
            removeOldest();
        } catch (BadLocationException e) {
            throw new IllegalStateException("lines go to the end", e);
        }
    }

    /** Puts a message in place of another one, if that is there. */
    void replace(Message old, Message present) {
        int index = messages.lastIndexOf(old);
        if (index < 0) {
            return;
        }
        Element line = getDefaultRootElement().getElement(index);
        int start = line.getStartOffset();
        try {
            AttributeSet look = getCharacterElement(start).getAttributes();
            replace(start, line.getEndOffset() - 1 - start, present.text(withTimes), look);
            messages.set(index, present);
        } catch (BadLocationException e) {
            throw new IllegalStateException("the line is in the text", e);
        }
    }

    private static int endOfRun(List<Message> added, int from) {
        int to = from + 1;
        while (to < added.size()
                && added.get(to).line().kind() == added.get(from).line().kind()) {
            to++;
        }
        return to;
    }

    /**
     * Inserts consecutive messages of one kind as one text, so that the event dispatch thread can handle a click on
     * STOP during a flood of messages.
     */
    private void appendRun(List<Message> run) throws BadLocationException {
        String text = run.stream().map(message -> message.text(withTimes)).collect(Collectors.joining("\n"));
        SimpleAttributeSet look = new SimpleAttributeSet();
        look.setResolveParent(getStyle(run.get(0).line().kind().name()));
        insertString(getLength(), messages.isEmpty() ? text : "\n" + text, look);
        messages.addAll(run);
    }

    private void removeOldest() throws BadLocationException {
        int tooMany = messages.size() - MOST_LINES;
        if (tooMany > 0) {
            remove(0, getDefaultRootElement().getElement(tooMany - 1).getEndOffset());
            messages.subList(0, tooMany).clear();
        }
    }

    private static Color color(Line.Kind kind) {
        return switch (kind) {
            case COMMAND -> Palette.command();
            case ANSWER -> Palette.text();
            case NOTICE -> Palette.faint();
            case FAILURE, ERROR -> Palette.error();
            case ALARM -> Palette.paper();
        };
    }
}
