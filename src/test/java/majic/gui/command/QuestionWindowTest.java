package majic.gui.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.JTextField;
import majic.gui.TestWindow;
import majic.gui.ToyBot;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Questions of scripts above the command line. */
class QuestionWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    private final ToyBot bot = window.add("one");

    private void awaitQuestion(String text) {
        window.await(
                "the question",
                () -> window.isShowing("questionStrip")
                        && window.text("question").equals(text));
    }

    private void awaitNone() {
        window.await("no question", () -> !window.isShowing("questionStrip"));
    }

    @Test
    void aNumberIsTypedAndAnsweredByEnter() {
        window.command("ask far = 30mm from 0 to 200 \"How far?\" for 1000s");
        awaitQuestion("How far?");
        assertThat(window.text("answerField")).isEqualTo("30mm");
        assertThat(window.text("answerRange")).isEqualTo("0 … 200 mm");
        assertThat(window.text("questionDefault")).startsWith("otherwise 30 mm, in ");
        window.focus("answerField");
        window.run(() -> window.find("answerField", JTextField.class).selectAll());
        window.type("5cm");
        window.press(KeyEvent.VK_ENTER);
        awaitNone();
        window.awaitMessage("answer 5cm");
        window.await(
                "the focus on the command line",
                () -> window.find("commandLine", JTextField.class).isFocusOwner());
        window.command("1 move $far");
        window.awaitMessage("1 move 50mm: done");
        assertThat(bot.told).contains("move 50");
    }

    @Test
    void anAnswerThatDoesNotFitIsRefusedAndTheQuestionStays() {
        window.command("ask far = 30mm from 0 to 200 \"How far?\" for 1000s");
        awaitQuestion("How far?");
        window.focus("answerField");
        window.run(() -> window.find("answerField", JTextField.class).selectAll());
        window.type("3m");
        window.press(KeyEvent.VK_ENTER);
        window.await("the refusal", () -> window.isShowing("answerRefused"));
        assertThat(window.text("answerRefused")).contains("outside 0 … 200 mm");
        assertThat(window.text("question")).isEqualTo("How far?");
        window.type("0");
        assertThat(window.isShowing("answerRefused")).isFalse();
    }

    @Test
    void aChoiceHasAButtonForEachWord() {
        window.command("ask side = left or right \"Which side?\" for 1000s");
        awaitQuestion("Which side?");
        window.click("answer right");
        awaitNone();
        window.command("print $side");
        window.awaitMessage("right");
    }

    @Test
    void aTextIsAnsweredWithoutQuotes() {
        window.command("ask what = \"a cat\" \"What is it?\" for 1000s");
        awaitQuestion("What is it?");
        assertThat(window.text("answerField")).isEqualTo("a cat");
        window.click("answer");
        awaitNone();
        window.awaitMessage("answer \"a cat\"");
    }

    @Test
    void theFocusIsNotTaken() {
        window.focus("commandLine");
        window.command("ask far = 30mm \"How far?\" for 1000s");
        awaitQuestion("How far?");
        window.type("1 mo");
        assertThat(window.text("commandLine")).isEqualTo("1 mo");
        assertThat(window.text("answerField")).isEqualTo("30mm");
    }

    @Test
    void theKeyForStopWorksInTheFieldAndEndsTheQuestion(@TempDir Path folder) throws IOException {
        Path script =
                Files.writeString(folder.resolve("ask.majic"), "ask far = 30mm \"How far?\" for 1000s\n1 move $far\n");
        window.command("run \"" + script + "\"");
        awaitQuestion("How far?");
        window.focus("answerField");
        window.press(KeyEvent.VK_F12);
        window.await("STOP", window::isStopLatched);
        window.await("the end", () -> window.text("questionDefault").equals("this question has ended"));
        window.focus("commandLine");
        awaitNone();
        assertThat(bot.told).noneMatch(told -> told.startsWith("move"));
    }

    @Test
    void whatIsTypedForAQuestionThatHasEndedDoesNotGoToTheCommandLine() {
        window.command("ask far = 30mm \"How far?\" for 1000s");
        awaitQuestion("How far?");
        window.type("1 move 5");
        window.focus("answerField");
        window.parser.parseText("answer 20mm");
        window.await("the end", () -> window.text("questionDefault").equals("this question has ended"));
        window.type("00");
        window.press(KeyEvent.VK_ENTER);
        awaitNone();
        assertThat(window.text("commandLine")).isEqualTo("1 move 5");
        assertThat(bot.told).noneMatch(told -> told.startsWith("move"));
    }

    @Test
    void theOldestOfTwoQuestionsIsShownFirst(@TempDir Path folder) throws IOException {
        Path first = Files.writeString(
                folder.resolve("first.majic"), "ask one = yes \"First?\" for 1000s\nprint one $one\n");
        Path second = Files.writeString(
                folder.resolve("second.majic"), "ask two = no \"Second?\" for 1000s\nprint two $two\n");
        window.command("run \"" + first + "\"");
        awaitQuestion("First?");
        window.command("run \"" + second + "\"");
        window.await("two questions", () -> window.text("questionCount").equals("1 of 2"));
        window.click("answer no");
        awaitQuestion("Second?");
        window.awaitMessage("one no");
        assertThat(window.text("questionCount")).isEmpty();
        window.click("answer yes");
        awaitNone();
        window.awaitMessage("two yes");
    }

    @Test
    void aScriptThatIsRunAsAnActAsksAndPrintsToo(@TempDir Path folder) throws IOException {
        Path act = Files.writeString(
                folder.resolve("asking.majic"),
                "ask far = 30mm \"How far?\" for 1000s\nprint going $far\nme move $far\n");
        window.command("1 act \"" + act + "\"");
        awaitQuestion("How far?");
        window.focus("answerField");
        window.press(KeyEvent.VK_ENTER);
        awaitNone();
        window.awaitMessage("going 30 mm");
        window.await("the motion", () -> bot.told.contains("move 30"));
    }
}
