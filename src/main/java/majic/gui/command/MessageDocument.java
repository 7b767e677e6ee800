package majic.gui.command;

import java.awt.Color;
import java.util.List;
import java.util.stream.Collectors;
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
 * The text of the message area: a limited number of lines, each marked by its kind with a sign in front and a colour.
 * Must be used on the event dispatch thread.
 */
final class MessageDocument extends DefaultStyledDocument {
    static final int MOST_LINES = 2000;
    private static final long serialVersionUID = 1L;

    MessageDocument() {
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

    /** Appends lines; lines that would be removed at once are left out. */
    void append(List<Line> lines) {
        List<Line> newest = lines.subList(Math.max(0, lines.size() - MOST_LINES), lines.size());
        try {
            for (int from = 0, to; from < newest.size(); from = to) {
                to = endOfRun(newest, from);
                appendRun(newest.subList(from, to));
            }
            forgetOldest();
        } catch (BadLocationException e) {
            throw new IllegalStateException("lines go to the end", e);
        }
    }

    private static int endOfRun(List<Line> lines, int from) {
        int to = from + 1;
        while (to < lines.size() && lines.get(to).kind() == lines.get(from).kind()) {
            to++;
        }
        return to;
    }

    /**
     * Inserts consecutive lines of one kind as one text, so that the event dispatch thread can handle a click on STOP
     * during a flood of lines.
     */
    private void appendRun(List<Line> run) throws BadLocationException {
        Line.Kind kind = run.get(0).kind();
        String text = run.stream().map(line -> sign(kind) + line.text()).collect(Collectors.joining("\n"));
        SimpleAttributeSet look = new SimpleAttributeSet();
        look.setResolveParent(getStyle(kind.name()));
        insertString(getLength(), getLength() == 0 ? text : "\n" + text, look);
    }

    private void forgetOldest() throws BadLocationException {
        Element root = getDefaultRootElement();
        int tooMany = root.getElementCount() - MOST_LINES;
        if (tooMany > 0) {
            remove(0, root.getElement(tooMany - 1).getEndOffset());
        }
    }

    private static String sign(Line.Kind kind) {
        return switch (kind) {
            case COMMAND -> "> ";
            case ANSWER -> "  ";
            case NOTICE -> "* ";
            case FAILURE, ERROR -> "! ";
            case ALARM -> "\u203c ";
        };
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
