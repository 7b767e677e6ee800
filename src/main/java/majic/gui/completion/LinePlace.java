package majic.gui.completion;

import javax.swing.text.BadLocationException;
import javax.swing.text.Element;
import javax.swing.text.JTextComponent;
import majic.script.MajicParser;

/**
 * A place in a line of a text. Immutable.
 *
 * @param start the offset of the line in the text
 * @param line the line without its end
 * @param index 0 to the length of the line
 */
public record LinePlace(int start, String line, int index) {
    /**
     * Returns the place at an offset of a text. Must be called on the event dispatch thread.
     *
     * @param offset 0 to the length of the text
     */
    public static LinePlace at(JTextComponent text, int offset) {
        Element lines = text.getDocument().getDefaultRootElement();
        Element line = lines.getElement(lines.getElementIndex(offset));
        int start = line.getStartOffset();
        try {
            return new LinePlace(start, text.getText(start, line.getEndOffset() - 1 - start), offset - start);
        } catch (BadLocationException e) {
            throw new IllegalStateException("no offset " + offset, e);
        }
    }

    /** Returns the number of the line in its text, from 1. Must be called on the event dispatch thread. */
    public int number(JTextComponent text) {
        return text.getDocument().getDefaultRootElement().getElementIndex(start) + 1;
    }

    /** Returns the line up to the place. */
    public String before() {
        return line.substring(0, index);
    }

    /** Returns whether files are read to find what could stand here. */
    public boolean readsFiles() {
        return MajicParser.readsFiles(before());
    }
}
