package majic.gui.editor;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JTable;
import majic.gui.TestWindow;
import majic.gui.ToyBot;
import org.assertj.swing.edt.GuiActionRunner;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests how the editor runs scripts, on robots that are made up. */
class ScriptRunWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    private final TestEditor editor;

    ScriptRunWindowTest(@TempDir Path folder) {
        editor = new TestEditor(window, folder);
    }

    @Test
    @Tag("jdk")
    void aScriptDroppedOnTheWindowShowsItsRobotsAndRuns() throws IOException {
        ToyBot bot = window.add("one");
        editor.open("lap.majic", "1 move 30", "1 turn 20");
        editor.awaitStatus("No mistakes");
        assertThat(window.text("scriptRobots")).isEqualTo("1 Toy");
        window.press(KeyEvent.VK_F5);
        editor.awaitStatus("Last run: done");
        assertThat(bot.told).containsExactly("move 30", "turn 20");
        window.awaitMessage("run lap.majic: done");
    }

    @Test
    void aScriptIsRunLineByLine() throws IOException {
        ToyBot bot = window.add("one");
        RSyntaxTextArea area = editor.open("lap.majic", "# a lap", "1 move 30", "1 move 40", "1 move 50");
        editor.awaitStatus("No mistakes");
        window.press(KeyEvent.VK_F7);
        editor.awaitStatus("Paused before line 2");
        assertThat(area.isEditable()).isFalse();
        window.press(KeyEvent.VK_F7);
        editor.awaitStatus("Paused before line 3");
        assertThat(bot.told).containsExactly("move 30");
        window.press(KeyEvent.VK_F5);
        editor.awaitStatus("Last run: done");
        assertThat(bot.told).containsExactly("move 30", "move 40", "move 50");
        assertThat(area.isEditable()).isTrue();
    }

    @Test
    void aPausedScriptShowsTheValuesOfItsNames() throws IOException {
        window.add("one");
        editor.open("count.majic", "let n = 1", "let side = 20mm * $n", "let n = $n + 1", "1 move $side");
        editor.awaitStatus("No mistakes");
        assertThat(window.isShowing("scriptValues")).isFalse();
        window.press(KeyEvent.VK_F7);
        editor.awaitStatus("Paused before line 1");
        assertThat(window.isShowing("scriptValues")).isFalse();
        window.press(KeyEvent.VK_F7);
        editor.awaitStatus("Paused before line 2");
        assertThat(values()).isEqualTo("$n 1");
        window.press(KeyEvent.VK_F7);
        editor.awaitStatus("Paused before line 3");
        assertThat(values()).isEqualTo("$n 1, $side 20 mm");
        window.press(KeyEvent.VK_F7);
        editor.awaitStatus("Paused before line 4");
        assertThat(values()).isEqualTo("$n 2, $side 20 mm");
        window.press(KeyEvent.VK_F5);
        editor.awaitStatus("Last run: done");
        assertThat(window.isShowing("scriptValues")).isFalse();
    }

    @Test
    void aMistakeInAnExpressionIsMarkedBeforeTheScriptRuns() throws IOException {
        window.add("one");
        editor.open("wrong.majic", "let n = 1mm", "1 move ($n + 90deg)", "1 move $m");
        editor.awaitStatus("2 mistakes");
    }

    /** Returns the names and values that are shown. */
    private String values() {
        JTable table = window.awaitShowing("scriptValues", JTable.class);
        return IntStream.range(0, table.getRowCount())
                .mapToObj(row -> table.getValueAt(row, 0) + " " + table.getValueAt(row, 1))
                .collect(Collectors.joining(", "));
    }

    @Test
    void aScriptAsksInTheEditorToo() throws IOException {
        ToyBot bot = window.add("one");
        editor.open("ask.majic", "ask far = 30mm \"How far?\" for 1000s", "1 move $far");
        editor.awaitStatus("No mistakes");
        window.press(KeyEvent.VK_F5);
        window.await(
                "the question in the editor",
                () -> find("answerField").filter(Component::isShowing).isPresent());
        Component field = find("answerField").orElseThrow();
        window.focus(field);
        window.press(KeyEvent.VK_ENTER);
        editor.awaitStatus("Last run: done");
        assertThat(bot.told).containsExactly("move 30");
    }

    /** Finds a component of the editor; the main window may have one of the same name. */
    private Optional<Component> find(String name) {
        return GuiActionRunner.execute(() -> components(editor.frame())
                .filter(component -> name.equals(component.getName()))
                .findFirst());
    }

    private static Stream<Component> components(Container parent) {
        return Stream.of(parent.getComponents())
                .flatMap(child -> Stream.concat(
                        Stream.of(child),
                        child instanceof Container container ? components(container) : Stream.empty()));
    }

    @Test
    void theSelectedLinesRunAlone() throws IOException {
        ToyBot bot = window.add("one");
        RSyntaxTextArea area = editor.open("lap.majic", "1 move 30", "1 move 40", "1 move 50");
        editor.awaitStatus("No mistakes");
        window.run(
                () -> area.select(area.getText().indexOf("40"), area.getText().indexOf("50")));
        window.pressWithCtrl(KeyEvent.VK_F5);
        editor.awaitStatus("Last run: done");
        assertThat(bot.told).containsExactly("move 40", "move 50");
        window.awaitMessage("run lap.majic (lines 2 to 3): done");
    }

    @Test
    void theKeysForStopWorkInTheEditor() throws IOException {
        ToyBot bot = window.add("one");
        editor.open("lap.majic", "1 move 30", "wait 100s");
        editor.awaitStatus("No mistakes");
        window.press(KeyEvent.VK_F5);
        editor.awaitStatus("Running line 2");
        window.press(KeyEvent.VK_ESCAPE);
        editor.awaitStatus("Last run: stopped");
        awaitHalt(bot);
        window.await("STOP in the editor", () -> window.text("smallStop").equals("STOPPED"));
        window.run(window.team::release);
        window.press(KeyEvent.VK_F12);
        assertThat(window.isStopLatched()).isTrue();
    }

    @Test
    void endStopsTheScriptAndNotTheOtherRobots() throws IOException {
        ToyBot bot = window.add("one");
        ToyBot other = window.add("two");
        editor.open("lap.majic", "1 move 30", "wait 100s");
        editor.awaitStatus("No mistakes");
        window.press(KeyEvent.VK_F5);
        editor.awaitStatus("Running line 2");
        window.push("editor End");
        editor.awaitStatus("Last run: stopped");
        awaitHalt(bot);
        assertThat(other.told).isEmpty();
        assertThat(window.isStopLatched()).isFalse();
    }

    private void awaitHalt(ToyBot bot) {
        window.await(
                "the robot to halt",
                () -> List.copyOf(bot.told).lastIndexOf("halt") == bot.told.size() - 1 && !bot.told.isEmpty());
    }
}
