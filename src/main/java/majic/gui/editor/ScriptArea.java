package majic.gui.editor;

import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.HashSet;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.text.BadLocationException;
import javax.swing.text.Element;
import majic.gui.kit.ClosesByEsc;
import majic.gui.kit.EventThread;
import majic.gui.kit.Palette;
import majic.script.ScriptRunner;
import majic.script.run.ScriptControl.Progress;
import majic.script.syntax.Mistake;
import majic.script.syntax.Scanner;
import majic.script.syntax.Token;
import majic.text.Texts;
import org.fife.ui.rsyntaxtextarea.RSyntaxDocument;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rsyntaxtextarea.parser.AbstractParser;
import org.fife.ui.rsyntaxtextarea.parser.DefaultParseResult;
import org.fife.ui.rsyntaxtextarea.parser.DefaultParserNotice;
import org.fife.ui.rsyntaxtextarea.parser.ParseResult;
import org.fife.ui.rtextarea.RTextScrollPane;

/** The text of a script with its line numbers: underlines mistakes, and marks the lines that run. */
final class ScriptArea extends RTextScrollPane implements ClosesByEsc {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(ScriptArea.class);
    private static final Progress NONE = new Progress(false, Set.of(), OptionalInt.empty(), List.of(), "");

    private final RSyntaxTextArea text;
    private final transient ScriptTokens tokens = new ScriptTokens();
    private final transient Mistakes mistakes = new Mistakes();
    private transient Set<String> procedures = Set.of();
    private final transient ScriptCompletion completion;
    private final transient WordHints hints;
    private transient Progress shown = NONE;

    ScriptArea(ScriptRunner runner) {
        super(new RSyntaxTextArea());
        text = (RSyntaxTextArea) getTextArea();
        ((RSyntaxDocument) text.getDocument()).setSyntaxStyle(tokens);
        text.setName("script");
        text.getAccessibleContext().setAccessibleName(TEXTS.get("script"));
        text.setTabsEmulated(true);
        text.setTabSize(2);
        text.setAnimateBracketMatching(false);
        text.setUseFocusableTips(false);
        text.addParser(mistakes);
        completion = new ScriptCompletion(text, runner);
        hints = new WordHints(text, runner);
        setBorder(BorderFactory.createEmptyBorder());
        setIconRowHeaderEnabled(true);
        setLineNumbersEnabled(true);
        EditorColors.current().apply(text, getGutter());
    }

    @Override
    public boolean hasToClose() {
        return completion.isShowing();
    }

    RSyntaxTextArea text() {
        return text;
    }

    /** Sets the colours of the look and feel, once the look and feel has changed the text as well. */
    @Override
    public void updateUI() {
        super.updateUI();
        if (text != null) {
            EventThread.later(this::recolour);
        }
    }

    private void recolour() {
        EditorColors.current().apply(text, getGutter());
        Progress now = shown;
        shown = NONE;
        show(now);
        text.forceReparsing(mistakes);
    }

    /** Colours the words that call procedures, which are in lower case. */
    void showProcedures(Set<String> words) {
        if (!words.equals(procedures)) {
            procedures = words;
            tokens.setProcedures(words);
            ((RSyntaxDocument) text.getDocument()).setSyntaxStyle(tokens);
        }
    }

    /** Underlines mistakes in place of those underlined before. */
    void show(List<Mistake> found) {
        mistakes.found = found;
        text.forceReparsing(mistakes);
    }

    /** Marks the lines that run and the one that runs next, and scrolls to the first of them. */
    void show(Progress progress) {
        if (progress.running().equals(shown.running()) && progress.next().equals(shown.next())) {
            return;
        }
        shown = progress;
        text.removeAllLineHighlights();
        getGutter().removeAllTrackingIcons();
        EditorColors colors = EditorColors.current();
        Set<Integer> marked = new HashSet<>(progress.running());
        progress.running().forEach(line -> mark(line, colors.running(), new LineSign(true)));
        progress.next().ifPresent(line -> {
            if (marked.add(line)) {
                mark(line, colors.next(), new LineSign(false));
            }
        });
        marked.stream().sorted().findFirst().ifPresent(this::reveal);
    }

    private void mark(int line, Color color, Icon sign) {
        if (line > text.getLineCount()) {
            return;
        }
        try {
            text.addLineHighlight(line - 1, color);
            getGutter().addLineTrackingIcon(line - 1, sign, sign.toString());
        } catch (BadLocationException e) {
            throw new IllegalStateException("no line " + line, e);
        }
    }

    /** Returns where the caret is, in words. */
    String caretPlace() {
        return TEXTS.get("caret", text.getCaretLineNumber() + 1, text.getCaretOffsetFromLineStart() + 1);
    }

    /** Returns one line on the word at the caret, or on what is expected there; empty if nothing is known of it. */
    String hint() {
        return hints.atCaret();
    }

    /** Puts the caret at a place, which is scrolled to. */
    void goTo(int line, int column) {
        try {
            int start = text.getLineStartOffset(Math.min(line, text.getLineCount()) - 1);
            text.setCaretPosition(
                    Math.min(start + column - 1, text.getDocument().getLength()));
            text.requestFocusInWindow();
        } catch (BadLocationException e) {
            throw new IllegalStateException("no line " + line, e);
        }
    }

    private void reveal(int line) {
        if (line > text.getLineCount()) {
            return;
        }
        try {
            Rectangle2D place = text.modelToView2D(text.getLineStartOffset(line - 1));
            if (place != null) {
                Rectangle visible = place.getBounds();
                visible.grow(0, 2 * text.getLineHeight());
                text.scrollRectToVisible(visible);
            }
        } catch (BadLocationException e) {
            throw new IllegalStateException("no line " + line, e);
        }
    }

    /**
     * Some whole lines of the text. Immutable.
     *
     * @param first the number of the first line, from 1
     * @param last the number of the last line
     * @param text the lines
     */
    record Lines(int first, int last, String text) {
        /** Returns the lines behind as many empty ones as stand before them, so that places in them stay the same. */
        String inPlace() {
            return "\n".repeat(first - 1) + text;
        }

        String title() {
            return first == last ? " (line " + first + ")" : " (lines " + first + " to " + last + ")";
        }
    }

    /** Returns the lines of the selection, or that of the caret. */
    Lines selectedLines() {
        try {
            int first = text.getLineOfOffset(text.getSelectionStart());
            int last = text.getLineOfOffset(text.getSelectionEnd());
            if (last > first && text.getSelectionEnd() == text.getLineStartOffset(last)) {
                last--;
            }
            int start = text.getLineStartOffset(first);
            String lines = text.getText(start, text.getLineEndOffset(last) - start);
            return new Lines(first + 1, last + 1, lines);
        } catch (BadLocationException e) {
            throw new IllegalStateException("no such selection", e);
        }
    }

    /** Passes the mistakes that were found in the background on to the text. */
    private static final class Mistakes extends AbstractParser {
        private List<Mistake> found = List.of();

        @Override
        public ParseResult parse(RSyntaxDocument document, String style) {
            DefaultParseResult result = new DefaultParseResult(this);
            Element lines = document.getDefaultRootElement();
            for (Mistake mistake : found) {
                if (mistake.line() <= lines.getElementCount()) {
                    result.addNotice(notice(mistake, lines.getElement(mistake.line() - 1), document));
                }
            }
            return result;
        }

        private DefaultParserNotice notice(Mistake mistake, Element line, RSyntaxDocument document) {
            int length = line.getEndOffset() - line.getStartOffset() - 1;
            int start = Math.min(mistake.column() - 1, Math.max(0, length - 1));
            int end = Math.max(start + 1, wordEnd(document, line, mistake.column()));
            DefaultParserNotice notice = new DefaultParserNotice(
                    this, mistake.message(), mistake.line() - 1, line.getStartOffset() + start, end - start);
            notice.setColor(Palette.error());
            return notice;
        }

        /** The end of the word that begins at a column; of a line that ends there, its end. */
        private static int wordEnd(RSyntaxDocument document, Element line, int column) {
            try {
                String text = document.getText(line.getStartOffset(), line.getEndOffset() - line.getStartOffset() - 1);
                return Scanner.scan(text).stream()
                                .filter(token -> token.column() == column)
                                .mapToInt(Token::end)
                                .findFirst()
                                .orElse(column + 1)
                        - 1;
            } catch (BadLocationException e) {
                return column;
            }
        }
    }

    /** A filled arrow beside a line that runs, an open one beside the line that runs next. */
    private record LineSign(boolean runs) implements Icon {
        private static final int SIZE = 12;

        @Override
        public void paintIcon(Component component, Graphics g, int x, int y) {
            Graphics2D pen = (Graphics2D) g.create();
            pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            pen.setColor(Palette.text());
            Path2D arrow = new Path2D.Double();
            arrow.moveTo(x + 2, y + 1.5);
            arrow.lineTo(x + 10, y + 6);
            arrow.lineTo(x + 2, y + 10.5);
            arrow.closePath();
            if (runs) {
                pen.fill(arrow);
            }
            pen.draw(arrow);
            pen.dispose();
        }

        @Override
        public int getIconWidth() {
            return SIZE;
        }

        @Override
        public int getIconHeight() {
            return SIZE;
        }

        @Override
        public String toString() {
            return runs ? TEXTS.get("line.running") : TEXTS.get("line.next");
        }
    }
}
