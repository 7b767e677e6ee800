package majic.gui.command;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatLaf;
import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.datatransfer.StringSelection;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.JList;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import majic.gui.TestWindow;
import majic.gui.ToyBot;
import majic.script.help.Completion;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

class CommandLineWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    private final ToyBot bot = window.add("one");

    @Test
    void aValidLineIsClearedAwayAndItsAnswerShown() {
        window.command("1 move 50");
        assertThat(window.text("commandLine")).isEmpty();
        window.awaitMessage("1 move 50: done");
        assertThat(bot.told).contains("move 50");
    }

    @Test
    void aWrongLineStaysWithItsMessageUntilItIsCorrected() {
        window.command("7 move 50");
        assertThat(window.text("commandLine")).isEqualTo("7 move 50");
        assertThat(window.text("hint")).contains("7").contains("no robot");
        window.type(" ");
        assertThat(window.text("hint")).doesNotContain("no robot");
    }

    @Test
    void arrowKeysWalkThroughEarlierLines() {
        window.command("1 move 10");
        window.command("1 move 20");
        window.press(KeyEvent.VK_UP);
        window.press(KeyEvent.VK_UP);
        assertThat(window.text("commandLine")).isEqualTo("1 move 10");
        window.press(KeyEvent.VK_DOWN);
        assertThat(window.text("commandLine")).isEqualTo("1 move 20");
    }

    @Test
    void aLineThatNamesABehaviourIsCheckedBesideTheWindow() {
        window.command("1 act Nowhere");
        window.await("the check", () -> window.text("hint").contains("there is no act Nowhere"));
        assertThat(window.text("commandLine")).isEqualTo("1 act Nowhere");
        assertThat(selected()).isEqualTo("Nowhere");
        window.focus("commandLine");
        window.press(KeyEvent.VK_END);
        window.type(" ");
        window.await("the line to be mended", () -> window.text("commandLine").equals("1 act Nowhere "));
    }

    @Test
    void anArrowKeyHeldFromDrivingRecallsNoLine() {
        window.command("1 move 10");
        window.focus("drivePad");
        arrow("drivePad", KeyEvent.KEY_PRESSED, 1000);
        window.focus("commandLine");
        arrow("commandLine", KeyEvent.KEY_RELEASED, 1500);
        arrow("commandLine", KeyEvent.KEY_PRESSED, 1501);
        assertThat(window.text("commandLine")).isEmpty();

        arrow("commandLine", KeyEvent.KEY_RELEASED, 1530);
        arrow("commandLine", KeyEvent.KEY_PRESSED, 1700);
        assertThat(window.text("commandLine")).isEqualTo("1 move 10");
    }

    /** Dispatches an event of the arrow key Up as the system does while the key repeats. */
    private void arrow(String name, int event, long whenMs) {
        Component component = window.find(name, Component.class);
        window.run(() -> component.dispatchEvent(
                new KeyEvent(component, event, whenMs, 0, KeyEvent.VK_UP, KeyEvent.CHAR_UNDEFINED)));
    }

    @Test
    void whatIsTypedIsKeptWhenTheLookChangesAndTheFocusReturns() {
        window.focus("commandLine");
        window.type("3 mov");
        window.run(FlatLaf::updateUI);
        window.focus("drivePad");
        window.focus("commandLine");
        window.type("e 50");
        assertThat(window.text("commandLine")).isEqualTo("3 move 50");
    }

    @Test
    void tabCompletesAParameter() {
        window.focus("commandLine");
        window.type("1 get cruiseT");
        window.press(KeyEvent.VK_TAB);
        assertThat(window.text("commandLine").strip()).isEqualTo("1 get cruiseTurn");
    }

    @Test
    void theWrongWordIsSelectedSoThatTypingReplacesIt() {
        window.command("1 mvoe 50");
        assertThat(selected()).isEqualTo("mvoe");
        window.type("move");
        assertThat(window.text("commandLine")).isEqualTo("1 move 50");
    }

    @Test
    void aNewLineTypedOverTheWrongWordReplacesTheWholeLine() {
        window.command("1 mvoe 50");
        window.type("1 get cruise");
        assertThat(window.text("commandLine")).isEqualTo("1 get cruise");
        window.run(() -> line().setText(""));
        window.command("7 move 50");
        window.type("1 move 60");
        assertThat(window.text("commandLine")).isEqualTo("1 move 60");
        window.run(() -> line().setText(""));
        window.command("1 set cruise 9999");
        window.type("2 get sonar");
        assertThat(window.text("commandLine")).isEqualTo("2 get sonar");
    }

    @Test
    void aWrongValueIsReplacedByWhatIsTypedAlsoIfMoreFollows() {
        window.command("1 move 50xx");
        assertThat(window.text("hint")).isNotEmpty();
        window.run(() -> line().select("1 move ".length(), line().getText().length()));
        window.type("300 until x > 5");
        assertThat(window.text("commandLine")).isEqualTo("1 move 300 until x > 5");
    }

    private JTextField line() {
        return window.find("commandLine", JTextField.class);
    }

    @Test
    void ctrlUEmptiesTheLineWithoutStopping() {
        window.focus("commandLine");
        window.type("1 mo");
        assertThat(window.text("hint")).contains("Esc: close the list");
        window.pressWithCtrl(KeyEvent.VK_U);
        assertThat(window.text("commandLine")).isEmpty();
        assertThat(window.isShowing("choices")).isFalse();
        assertThat(window.text("hint")).doesNotContain("Esc");
        assertThat(window.isStopLatched()).isFalse();
    }

    @Test
    void whatEscWillDoIsShownWhileALineIsTyped() {
        window.focus("commandLine");
        window.type("1 mo");
        window.press(KeyEvent.VK_ESCAPE);
        assertThat(window.text("hint")).contains("Esc: STOP for all robots", "Ctrl U: empty the line");
    }

    @Test
    void severalPastedLinesRunOneAfterTheOtherAfterAQuestionThatShowsThem() {
        paste("1 move 11 # a comment\n\n1 turn 22\r\n");
        window.awaitDialogWithKeys("Pasted Lines");
        assertThat(window.text("pastedLines")).contains("1 move 11 # a comment", "1 turn 22");
        assertThat(bot.told).isEmpty();
        window.push("pasted.run");
        window.await("the last line", () -> bot.told.contains("turn 22"));
        assertThat(bot.told).contains("move 11");
        assertThat(window.text("commandLine")).isEmpty();
    }

    @Test
    void aRefusedPastedLineComesIntoTheLineAndThoseBehindItDoNotRun() {
        paste("1 move 11\n1 trun 22\n1 move 33");
        window.awaitDialog("Pasted Lines");
        window.push("pasted.run");
        window.await("the refused line", () -> window.text("commandLine").equals("1 trun 22"));
        assertThat(selected()).isEqualTo("trun");
        assertThat(window.text("hint")).contains("did you mean turn?").contains("not run: 1");
        assertThat(bot.told).doesNotContain("move 33");
    }

    @Test
    void pastedLinesAreOpenedInTheEditor() {
        paste("1 move 11\n1 turn 22");
        window.awaitDialog("Pasted Lines");
        window.push("pasted.edit");
        JTextComponent script = window.awaitShowing("script", JTextComponent.class);
        assertThat(script.getText()).isEqualTo("1 move 11\n1 turn 22");
        assertThat(bot.told).isEmpty();
    }

    @Test
    void onePastedLineIsInsertedWithoutItsEnd() {
        window.focus("commandLine");
        window.type("1 ");
        paste("move 11\n");
        assertThat(window.text("commandLine")).isEqualTo("1 move 11");
    }

    private void paste(String text) {
        window.focus("commandLine");
        window.run(() -> {
            Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new StringSelection(text), null);
            line().paste();
        });
    }

    @Test
    void enterLeavesASearchWithoutAMatch() {
        window.command("1 move 11");
        window.pressWithCtrl(KeyEvent.VK_R);
        window.type("1 get cruise");
        window.press(KeyEvent.VK_ENTER);
        assertThat(window.isShowing("choices")).isFalse();
        assertThat(window.text("commandLine")).isEqualTo("1 get cruise");
        window.press(KeyEvent.VK_ENTER);
        window.awaitMessage("1 cruise = ");
    }

    @Test
    void aLineRefusedForAReasonOutsideOfItIsSelectedSoThatEnterRepeatsItAndTypingReplacesIt() {
        window.command("stop");
        window.awaitMessage("STOP is latched");
        window.command("1 move 50");
        assertThat(window.text("hint")).contains("STOP is latched");
        assertThat(selected()).isEqualTo("1 move 50");
        window.type("release");
        assertThat(window.text("commandLine")).isEqualTo("release");
    }

    @Test
    void theWordsThatFitAreShownWhileALineIsTyped() {
        window.focus("commandLine");
        window.type("1 set cru");
        window.await("the completions", () -> choices().contains("cruise"));
        assertThat(choices()).contains("cruiseTurn");
    }

    @Test
    void enterRunsTheLineUnlessAnEntryWasChosen() {
        window.focus("commandLine");
        window.type("1 mo");
        window.await("the completions", () -> choices().contains("move"));
        window.press(KeyEvent.VK_DOWN);
        window.press(KeyEvent.VK_ENTER);
        assertThat(window.text("commandLine")).isEqualTo("1 move ");
        window.type("50");
        window.await("the hint", () -> choices().equals(List.of("")));
        window.press(KeyEvent.VK_ENTER);
        window.awaitMessage("1 move 50: done");
        assertThat(window.isShowing("choices")).isFalse();
    }

    @Test
    void tabPutsOneCompletionAfterTheOtherIntoTheLine() {
        window.focus("commandLine");
        window.type("1 get cr");
        window.press(KeyEvent.VK_TAB);
        assertThat(window.text("commandLine")).isEqualTo("1 get cruise");
        window.press(KeyEvent.VK_TAB);
        window.press(KeyEvent.VK_TAB);
        assertThat(window.text("commandLine")).isEqualTo("1 get cruiseTurn");
        window.press(KeyEvent.VK_ENTER);
        window.awaitMessage("1 get cruiseTurn");
    }

    @Test
    void escClosesTheCompletionsWithoutStopping() {
        window.focus("commandLine");
        window.type("1 mo");
        window.await("the completions", () -> window.isShowing("choices"));
        window.press(KeyEvent.VK_ESCAPE);
        assertThat(window.isShowing("choices")).isFalse();
        assertThat(window.text("commandLine")).isEqualTo("1 mo");
        assertThat(window.isStopLatched()).isFalse();
        window.press(KeyEvent.VK_ESCAPE);
        window.await("the latch", window::isStopLatched);
    }

    @Test
    void aLetterTypedJustBeforeEscOpensNoListAfterIt() {
        window.focus("commandLine");
        window.type("1 mo");
        window.await("the completions", () -> window.isShowing("choices"));
        window.typeAndEsc("commandLine", 'v');
        assertThat(window.text("commandLine")).isEqualTo("1 mov");
        assertThat(window.isShowing("choices")).isFalse();
        assertThat(window.isStopLatched()).isFalse();
        window.press(KeyEvent.VK_ESCAPE);
        window.await("the latch", window::isStopLatched);
    }

    @Test
    void aLetterTypedJustBeforeEscOpensNoListAfterASearch() {
        window.command("1 move 11");
        window.pressWithCtrl(KeyEvent.VK_R);
        window.typeAndEsc("commandLine", 'm');
        assertThat(window.isShowing("choices")).isFalse();
        window.press(KeyEvent.VK_ESCAPE);
        window.await("the latch", window::isStopLatched);
    }

    @Test
    void f12StopsWhileTheCompletionsAreShown() {
        window.focus("commandLine");
        window.type("1 mo");
        window.await("the completions", () -> window.isShowing("choices"));
        window.press(KeyEvent.VK_F12);
        window.await("the latch", window::isStopLatched);
    }

    @Test
    void earlierLinesAreFoundByAPartOfThemAndTakenWithoutRunning() {
        window.command("1 move 11");
        window.command("1 turn 22");
        window.command("1 move 33");
        window.pressWithCtrl(KeyEvent.VK_R);
        window.type("mov");
        window.await("the lines", () -> choices().equals(List.of("1 move 33", "1 move 11")));
        window.pressWithCtrl(KeyEvent.VK_R);
        window.press(KeyEvent.VK_ENTER);
        assertThat(window.text("commandLine")).isEqualTo("1 move 11");
        assertThat(bot.told.stream().filter("move 11"::equals)).hasSize(1);
    }

    @Test
    void escEndsTheSearchAndBringsTheTypedTextBack() {
        window.command("1 move 11");
        window.type("1 tu");
        window.pressWithCtrl(KeyEvent.VK_R);
        window.type("x");
        window.press(KeyEvent.VK_ESCAPE);
        assertThat(window.text("commandLine")).isEqualTo("1 tu");
        assertThat(window.isStopLatched()).isFalse();
    }

    @Test
    void lettersAndDigitsTypedOnAnotherComponentGoToTheCommandLine() {
        window.focus("drivePad");
        window.type("1 move 50");
        assertThat(window.text("commandLine")).isEqualTo("1 move 50");
        window.press(KeyEvent.VK_ENTER);
        window.awaitMessage("1 move 50: done");
    }

    @Test
    void whatIsTypedBeforeTheCommandLineHasTheFocusGoesThereToo() {
        window.focus("drivePad");
        Component pad = window.find("drivePad", Component.class);
        KeyboardFocusManager keys = KeyboardFocusManager.getCurrentKeyboardFocusManager();
        long now = System.currentTimeMillis();
        window.run(() -> "1 move"
                .chars()
                .forEach(key -> keys.dispatchEvent(
                        new KeyEvent(pad, KeyEvent.KEY_TYPED, now, 0, KeyEvent.VK_UNDEFINED, (char) key))));
        window.await("the line", () -> window.text("commandLine").equals("1 move"));
    }

    @Test
    void aSpaceThatNoComponentHasWhileTheFocusIsPassedOnGoesThereToo() {
        window.focus("drivePad");
        Component pad = window.find("drivePad", Component.class);
        Component frame = SwingUtilities.getWindowAncestor(pad);
        KeyboardFocusManager keys = KeyboardFocusManager.getCurrentKeyboardFocusManager();
        long now = System.currentTimeMillis();
        window.run(() -> {
            keys.dispatchEvent(new KeyEvent(pad, KeyEvent.KEY_TYPED, now, 0, KeyEvent.VK_UNDEFINED, '1'));
            keys.dispatchEvent(new KeyEvent(frame, KeyEvent.KEY_TYPED, now, 0, KeyEvent.VK_UNDEFINED, ' '));
        });
        window.await("the line", () -> window.text("commandLine").equals("1 "));
    }

    @Test
    void lettersTypedOnTheMessagesGoToTheCommandLine() {
        window.focus("messages");
        window.type("bots");
        assertThat(window.text("commandLine")).isEqualTo("bots");
    }

    @Test
    void aListAboveTheLineLeavesTheNewestMessagesInView() {
        window.run(() ->
                window.frame().setLocation(0, screenHeight() - window.frame().getHeight()));
        window.command("1 get cruise");
        window.awaitMessage("1 cruise = ");
        window.type("1 set ");
        window.await("the completions", () -> choices().contains("cruise"));
        MessageArea messages = window.find("messageArea", MessageArea.class);
        Rectangle list = window.find("choicesWindow", Window.class).getBounds();
        window.run(() -> {
            Point corner = messages.getLocationOnScreen();
            assertThat(list.y + list.height).isLessThan(corner.y + messages.getHeight() + 10);
            assertThat(list.x).isGreaterThan(corner.x + messages.textEnd(list.height));
        });
    }

    private static int screenHeight() {
        return Toolkit.getDefaultToolkit().getScreenSize().height;
    }

    private String selected() {
        JTextField line = window.find("commandLine", JTextField.class);
        String[] text = new String[1];
        window.run(() -> text[0] = line.getSelectedText());
        return text[0];
    }

    /** Returns the words in the popup; empty while it is hidden. */
    private List<String> choices() {
        if (!window.isShowing("choices")) {
            return List.of();
        }
        JList<?> list = window.find("choices", JList.class);
        List<String> words = new ArrayList<>();
        window.run(() -> IntStream.range(0, list.getModel().getSize())
                .forEach(index -> words.add(((Completion) list.getModel().getElementAt(index)).text())));
        return words;
    }
}
