package majic.gui;

import java.awt.Color;
import java.util.List;
import javax.swing.text.BadLocationException;
import javax.swing.text.DefaultStyledDocument;
import javax.swing.text.Element;
import javax.swing.text.Style;
import javax.swing.text.StyleConstants;
import javax.swing.text.StyleContext;
import majic.script.Line;

/**
 * The text of the message area: lines marked by kind with a sign in front and a colour, a limited number of them. Used on
 * the event dispatch thread.
 */
final class MessageDocument extends DefaultStyledDocument {
    static final int MOST_LINES = 2000;
    private static final long serialVersionUID = 1L;

    MessageDocument() {
        for (Line.Kind kind : Line.Kind.values()) {
            Style style = addStyle(kind.name(), getStyle(StyleContext.DEFAULT_STYLE));
            StyleConstants.setBold(style, kind == Line.Kind.COMMAND);
        }
        recolour();
    }

    /** Takes the colours of the look that is on now. */
    void recolour() {
        for (Line.Kind kind : Line.Kind.values()) {
            StyleConstants.setForeground(getStyle(kind.name()), color(kind));
        }
    }

    void append(List<Line> lines) {
        try {
            for (Line line : lines) {
                String text = sign(line.kind()) + line.text();
                insertString(getLength(), getLength() == 0 ? text : "\n" + text, null);
                setLogicalStyle(getLength(), getStyle(line.kind().name()));
            }
            forgetOldest();
        } catch (BadLocationException e) {
            throw new IllegalStateException("lines go to the end", e);
        }
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
            case ERROR -> "! ";
        };
    }

    private static Color color(Line.Kind kind) {
        return switch (kind) {
            case COMMAND -> Palette.command();
            case ANSWER -> Palette.text();
            case NOTICE -> Palette.faint();
            case ERROR -> Palette.error();
        };
    }
}
