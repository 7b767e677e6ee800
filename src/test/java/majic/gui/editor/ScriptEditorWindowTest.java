package majic.gui.editor;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Font;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.stream.IntStream;
import javax.swing.JFrame;
import javax.swing.JList;
import javax.swing.JTextField;
import majic.gui.Contrast;
import majic.gui.TestWindow;
import majic.gui.ToyBot;
import majic.gui.WindowAudit;
import majic.script.syntax.Mistake;
import org.assertj.swing.edt.GuiActionRunner;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rsyntaxtextarea.parser.ParserNotice;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests what the editor shows of a text, and how it helps to type it. */
class ScriptEditorWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    private final TestEditor editor;

    ScriptEditorWindowTest(@TempDir Path folder) {
        editor = new TestEditor(window, folder);
    }

    @Test
    void mistakesAreUnderlinedAndListedWithTheirReasons() throws IOException {
        window.add("one");
        RSyntaxTextArea area = editor.open("lap.majic", "1 move 30", "1 mvoe 3");
        editor.awaitStatus("1 mistake");
        ParserNotice notice = area.getParserNotices().get(0);
        assertThat(notice.getMessage()).contains("did you mean move?");
        assertThat(area.getText().substring(notice.getOffset(), notice.getOffset() + notice.getLength()))
                .isEqualTo("mvoe");
        JList<?> list = window.awaitShowing("mistakes", JList.class);
        window.run(() -> list.setSelectedIndex(0));
        window.focus(list);
        window.press(KeyEvent.VK_ENTER);
        assertThat(area.getCaretPosition()).isEqualTo(notice.getOffset());
        window.run(() -> area.replaceRange("move", notice.getOffset(), notice.getOffset() + 4));
        editor.awaitStatus("No mistakes");
        assertThat(window.isShowing("mistakes")).isFalse();
    }

    @Test
    void mistakesAreMarkedInsideABlockWithoutAnEnd() throws IOException {
        window.add("one");
        RSyntaxTextArea area = editor.open("lap.majic", "repeat 2", "  1 mvoe 3", "  if 1 x > 5", "    1 trun 3");
        editor.awaitStatus("4 mistakes");
        assertThat(area.getParserNotices()).extracting(ParserNotice::getLine).contains(0, 1, 2, 3);
    }

    @Test
    void mistakesAreMarkedInsideABlockWithAWrongEnd() throws IOException {
        window.add("one");
        editor.open("lap.majic", "repeat 2", "  1 mvoe 3", "end it");
        editor.awaitStatus("2 mistakes");
    }

    @Test
    void mistakesAreListedInTheOrderOfTheirLines() throws IOException {
        window.add("one");
        editor.open("lap.majic", "1 mvoe 3", "nonsense", "1 trun 3");
        editor.awaitStatus("3 mistakes");

        JList<?> list = window.awaitShowing("mistakes", JList.class);

        assertThat(IntStream.range(0, 3)
                        .mapToObj(row -> ((Mistake) list.getModel().getElementAt(row)).line()))
                .containsExactly(1, 2, 3);
    }

    @Test
    void aScriptIsCheckedAgainWhenARobotIsAdded() throws IOException {
        editor.open("lap.majic", "1 move 30");
        editor.awaitStatus("1 mistake");
        window.add("one");
        editor.awaitStatus("No mistakes");
    }

    @Test
    void wordsAreCompletedWhileTheyAreTyped() throws IOException {
        window.add("one");
        RSyntaxTextArea area = editor.open("lap.majic", "");
        window.type("1 tu");
        editor.awaitCompletions(true);
        window.press(KeyEvent.VK_ENTER);
        assertThat(area.getText()).isEqualTo("1 turn");
        window.type(" 9");
        window.press(KeyEvent.VK_ENTER);
        assertThat(area.getText()).isEqualTo("1 turn 9\n");
    }

    @Test
    void theWordsAtTheCaretAndUnderTheMouseAreExplained() throws IOException {
        window.add("one");
        RSyntaxTextArea area = editor.open("lap.majic", "1 turn 90", "");
        window.run(() -> area.setCaretPosition("1 tu".length()));
        assertThat(window.text("wordHint")).startsWith("turn ANGLE").contains("left positive");
        window.run(() -> area.setCaretPosition("1 turn ".length()));
        assertThat(window.text("wordHint")).isEqualTo("an angle (deg, rad)");
        window.run(() -> area.setCaretPosition(area.getText().length()));
        assertThat(window.text("wordHint")).isEmpty();
        Rectangle word = GuiActionRunner.execute(
                () -> area.modelToView2D("1 tu".length()).getBounds());
        assertThat(window.tipAt("script", new Point(word.x, word.y + 2))).startsWith("turn ANGLE");
        assertThat(window.tipAt("script", new Point(word.x + 400, word.y + 2))).isNull();
    }

    @Test
    void theNamesOfTheLinesAboveAreCompletedAndExplained() throws IOException {
        window.add("one");
        RSyntaxTextArea area = editor.open("lap.majic", "let side = 30mm", "");
        window.run(() -> area.setCaretPosition(area.getDocument().getLength()));
        window.type("1 move $s");
        editor.awaitCompletions(true);
        window.press(KeyEvent.VK_TAB);
        assertThat(area.getText()).endsWith("1 move $side");
        window.await("the explanation", () -> window.text("wordHint").equals("$side a number of mm"));
    }

    @Test
    void escClosesTheCompletionsAndStopsOnlyThen() throws IOException {
        ToyBot bot = window.add("one");
        editor.open("lap.majic", "");
        window.type("1 tu");
        editor.awaitCompletions(true);
        window.press(KeyEvent.VK_ESCAPE);
        editor.awaitCompletions(false);
        assertThat(bot.told).isEmpty();
        window.press(KeyEvent.VK_ESCAPE);
        window.await("the stop", () -> bot.told.contains("halt"));
    }

    @Test
    void aLetterTypedJustBeforeEscOpensNoListAfterIt() throws IOException {
        ToyBot bot = window.add("one");
        editor.open("lap.majic", "");
        window.type("1 t");
        editor.awaitCompletions(true);
        window.typeAndEsc("script", 'u');
        assertThat(window.isShowing("choicesWindow")).isFalse();
        assertThat(bot.told).isEmpty();
        window.press(KeyEvent.VK_ESCAPE);
        window.await("the stop", () -> bot.told.contains("halt"));
    }

    @Test
    void ctrlSpaceListsWordsWhereNoneIsBegun() throws IOException {
        window.add("one");
        RSyntaxTextArea area = editor.open("lap.majic", "");
        window.type("1 ");
        assertThat(window.isShowing("choicesWindow")).isFalse();
        window.pressWithCtrl(KeyEvent.VK_SPACE);
        editor.awaitCompletions(true);
        window.press(KeyEvent.VK_DOWN);
        window.press(KeyEvent.VK_TAB);
        assertThat(area.getText()).startsWith("1 ").doesNotContain("\t");
        editor.awaitCompletions(false);
    }

    @Test
    void theNamesOfTheScriptsArgumentsAreCompleted() throws IOException {
        RSyntaxTextArea area = editor.open("lap.majic", "argument far = 300mm", "");
        window.pressWithCtrl(KeyEvent.VK_END);
        window.type("me move $");
        editor.awaitCompletions(true);
        window.press(KeyEvent.VK_ENTER);
        window.await("the name", () -> area.getText().contains("me move $far"));
    }

    @Test
    void aTextIsFoundAndEscClosesTheBar() throws IOException {
        ToyBot bot = window.add("one");
        RSyntaxTextArea area = editor.open("lap.majic", "1 move 30", "1 turn 30", "1 stop");
        window.pressWithCtrl(KeyEvent.VK_F);
        window.awaitShowing("find", JTextField.class);
        window.focus("find");
        window.type("30");
        window.press(KeyEvent.VK_ENTER);
        window.press(KeyEvent.VK_ENTER);
        assertThat(window.text("findCount")).isEqualTo("2 found");
        assertThat(area.getSelectionStart()).isEqualTo(area.getText().lastIndexOf("30"));
        window.press(KeyEvent.VK_ESCAPE);
        window.await("the bar to close", () -> !window.isShowing("find"));
        assertThat(bot.told).isEmpty();
    }

    @Test
    void theColoursFollowTheLookAndTheFontStays() throws IOException {
        RSyntaxTextArea area = editor.open("lap.majic", "1 move 30");
        Font font = area.getFont();
        Color light = area.getBackground();
        window.run(window.entry("Dark")::doClick);
        window.await(
                "a dark text in its font",
                () -> area.getBackground().getRed() < 128 && area.getFont().equals(font));
        window.run(window.entry("Light")::doClick);
        window.await("a light text", () -> area.getBackground().equals(light));
    }

    @Test
    void everythingHasANameAndEveryEntryAMnemonic() throws IOException {
        editor.open("lap.majic", "1 move 30");
        editor.awaitStatus("1 mistake");
        window.pressWithCtrl(KeyEvent.VK_F);
        window.awaitShowing("find", JTextField.class);
        JFrame frame = editor.frame();
        window.run(() -> {
            assertThat(WindowAudit.nameless(frame)).isEmpty();
            assertThat(WindowAudit.mnemonicProblems(frame.getJMenuBar())).isEmpty();
            assertThat(WindowAudit.pale(frame, Contrast.TEXT)).isEmpty();
        });
    }
}
