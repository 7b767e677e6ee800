package majic.gui.editor;

import javax.swing.text.BadLocationException;
import majic.script.MajicParser;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;

/**
 * A place in a line of a script. Immutable.
 *
 * @param line the line without its end
 * @param index 0 to the length of the line
 */
record ScriptPlace(String line, int index) {
    /**
     * Returns the place at an offset of a text.
     *
     * @param offset 0 to the length of the text
     */
    static ScriptPlace at(RSyntaxTextArea text, int offset) {
        try {
            int number = text.getLineOfOffset(offset);
            int start = text.getLineStartOffset(number);
            String line = text.getText(start, text.getLineEndOffset(number) - start);
            return new ScriptPlace(line.endsWith("\n") ? line.substring(0, line.length() - 1) : line, offset - start);
        } catch (BadLocationException e) {
            throw new IllegalStateException("no offset " + offset, e);
        }
    }

    /** Whether files are read to find what could stand here. */
    boolean readsFiles() {
        return MajicParser.readsFiles(line.substring(0, index));
    }
}
