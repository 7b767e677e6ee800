package majic.gui.editor;

import java.awt.event.MouseEvent;
import java.awt.geom.Rectangle2D;
import javax.swing.text.BadLocationException;
import majic.gui.completion.LinePlace;
import majic.script.ScriptRunner;
import majic.script.help.Completion;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rtextarea.RTextArea;
import org.fife.ui.rtextarea.ToolTipSupplier;
import org.jspecify.annotations.Nullable;

/**
 * Explains the words of a script: the one under the mouse in a tool tip, and the one at the caret, or what is expected
 * there. Must be used on the event dispatch thread.
 */
final class WordHints implements ToolTipSupplier {
    private final RSyntaxTextArea text;
    private final ScriptRunner runner;

    WordHints(RSyntaxTextArea text, ScriptRunner runner) {
        this.text = text;
        this.runner = runner;
        text.setToolTipSupplier(this);
    }

    /**
     * Returns one line on the word at the caret; empty if nothing is known of it. While a deletion is reported to
     * listeners, the caret may still be behind the end of the text.
     */
    String atCaret() {
        return at(Math.min(text.getCaretPosition(), text.getDocument().getLength()));
    }

    private String at(int offset) {
        LinePlace place = LinePlace.at(text, offset);
        return runner.explain(place.line(), place.index(), runner.names(text.getText(), place.number(text)))
                .map(Completion::inWords)
                .orElse("");
    }

    /** Returns no tool tip beside and below the text. */
    @Override
    public @Nullable String getToolTipText(RTextArea area, MouseEvent event) {
        int offset = area.viewToModel2D(event.getPoint());
        String words = isOver(offset, event) ? at(offset) : "";
        return words.isEmpty() ? null : words;
    }

    private boolean isOver(int offset, MouseEvent event) {
        try {
            Rectangle2D place = text.modelToView2D(offset);
            return place != null
                    && Math.abs(event.getX() - place.getX())
                            <= text.getFontMetrics(text.getFont()).charWidth('m')
                    && event.getY() <= place.getMaxY();
        } catch (BadLocationException e) {
            return false;
        }
    }
}
