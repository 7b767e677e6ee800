package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Font;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JList;
import javax.swing.JMenu;
import javax.swing.JRootPane;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import javax.swing.TransferHandler.TransferSupport;
import majic.gui.kit.FileDrop;
import majic.script.syntax.Mistake;
import org.assertj.swing.edt.GuiActionRunner;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rsyntaxtextarea.parser.ParserNotice;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ScriptEditorWindowTest {
    @TempDir
    private Path folder;

    @AutoClose
    private final TestWindow window = TestWindow.open();

    private Path script(String name, String... lines) throws IOException {
        return Files.writeString(folder.resolve(name), String.join("\n", lines));
    }

    /** Drops a file on the main window, and waits until it is in the editor. */
    private RSyntaxTextArea drop(Path file) {
        JRootPane pane = window.frame.getRootPane();
        window.await("the window to accept files", () -> pane.getTransferHandler() instanceof FileDrop);
        TransferSupport files = new TransferSupport(pane, new DraggedFile(file));
        window.run(() -> {
            assertThat(pane.getTransferHandler().canImport(files)).isTrue();
            pane.getTransferHandler().importData(files);
        });
        String name = file.getFileName().toString();
        window.await(name + " in the editor", () -> isTitle(0, name) || isTitle(1, name));
        RSyntaxTextArea area = window.awaitShowing("script", RSyntaxTextArea.class);
        window.focus(area);
        return area;
    }

    private boolean isTitle(int index, String name) {
        if (!window.isShowing("scripts")) {
            return false;
        }
        JTabbedPane tabs = window.find("scripts", JTabbedPane.class);
        return index < tabs.getTabCount() && tabs.getTitleAt(index).endsWith(name);
    }

    private void awaitStatus(String status) {
        window.await(
                "the status \"" + status + "\"",
                () -> window.text("scriptStatus").startsWith(status));
    }

    private void awaitDialogAndPush(String dialog, String button) {
        window.awaitDialog(dialog);
        window.push(button);
    }

    private void closeEditor() {
        JFrame editor = window.find("editor", JFrame.class);
        window.run(() -> editor.dispatchEvent(new WindowEvent(editor, WindowEvent.WINDOW_CLOSING)));
    }

    @Test
    @Tag("jdk")
    void aScriptDroppedOnTheWindowShowsItsRobotsAndRuns() throws IOException {
        ToyBot bot = window.add("one");
        drop(script("lap.majic", "1 move 30", "1 turn 20"));
        awaitStatus("No mistakes");
        assertThat(window.text("scriptRobots")).isEqualTo("1 Toy");
        window.press(KeyEvent.VK_F5);
        awaitStatus("Last run: done");
        assertThat(bot.told).containsExactly("move 30", "turn 20");
        window.awaitMessage("run lap.majic: done");
    }

    @Test
    void mistakesAreUnderlinedAndListedWithTheirReasons() throws IOException {
        window.add("one");
        RSyntaxTextArea area = drop(script("lap.majic", "1 move 30", "1 mvoe 3"));
        awaitStatus("1 mistake");
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
        awaitStatus("No mistakes");
        assertThat(window.isShowing("mistakes")).isFalse();
    }

    @Test
    void mistakesAreListedInTheOrderOfTheirLines() throws IOException {
        window.add("one");
        drop(script("lap.majic", "1 mvoe 3", "nonsense", "1 trun 3"));
        awaitStatus("3 mistakes");

        JList<?> list = window.awaitShowing("mistakes", JList.class);

        assertThat(IntStream.range(0, 3)
                        .mapToObj(row -> ((Mistake) list.getModel().getElementAt(row)).line()))
                .containsExactly(1, 2, 3);
    }

    @Test
    void aScriptIsCheckedAgainWhenARobotIsAdded() throws IOException {
        drop(script("lap.majic", "1 move 30"));
        awaitStatus("1 mistake");
        window.add("one");
        awaitStatus("No mistakes");
    }

    @Test
    void aScriptIsRunLineByLine() throws IOException {
        ToyBot bot = window.add("one");
        RSyntaxTextArea area = drop(script("lap.majic", "# a lap", "1 move 30", "1 move 40", "1 move 50"));
        awaitStatus("No mistakes");
        window.press(KeyEvent.VK_F7);
        awaitStatus("Paused before line 2");
        assertThat(area.isEditable()).isFalse();
        window.press(KeyEvent.VK_F7);
        awaitStatus("Paused before line 3");
        assertThat(bot.told).containsExactly("move 30");
        window.press(KeyEvent.VK_F5);
        awaitStatus("Last run: done");
        assertThat(bot.told).containsExactly("move 30", "move 40", "move 50");
        assertThat(area.isEditable()).isTrue();
    }

    @Test
    void theSelectedLinesRunAlone() throws IOException {
        ToyBot bot = window.add("one");
        RSyntaxTextArea area = drop(script("lap.majic", "1 move 30", "1 move 40", "1 move 50"));
        awaitStatus("No mistakes");
        window.run(
                () -> area.select(area.getText().indexOf("40"), area.getText().indexOf("50")));
        window.pressWithCtrl(KeyEvent.VK_F5);
        awaitStatus("Last run: done");
        assertThat(bot.told).containsExactly("move 40", "move 50");
        window.awaitMessage("run lap.majic (lines 2 to 3): done");
    }

    @Test
    void theKeysForStopWorkInTheEditor() throws IOException {
        ToyBot bot = window.add("one");
        drop(script("lap.majic", "1 move 30", "wait 100s"));
        awaitStatus("No mistakes");
        window.press(KeyEvent.VK_F5);
        awaitStatus("Running line 2");
        window.press(KeyEvent.VK_ESCAPE);
        awaitStatus("Last run: stopped");
        awaitHalt(bot);
        window.await("STOP in the editor", () -> window.text("smallStop").equals("STOPPED"));
        window.run(window.team::release);
        window.press(KeyEvent.VK_F12);
        assertThat(window.team.isLatched()).isTrue();
    }

    @Test
    void endStopsTheScriptAndNotTheOtherRobots() throws IOException {
        ToyBot bot = window.add("one");
        ToyBot other = window.add("two");
        drop(script("lap.majic", "1 move 30", "wait 100s"));
        awaitStatus("No mistakes");
        window.press(KeyEvent.VK_F5);
        awaitStatus("Running line 2");
        window.push("editor End");
        awaitStatus("Last run: stopped");
        awaitHalt(bot);
        assertThat(other.told).isEmpty();
        assertThat(window.team.isLatched()).isFalse();
    }

    @Test
    void unsavedChangesAreAskedForBeforeTheEditorCloses() throws IOException {
        Path file = script("lap.majic", "1 move 30");
        RSyntaxTextArea area = drop(file);
        window.run(() -> area.append("\n1 stop"));
        closeEditor();
        awaitDialogAndPush("Unsaved Script", "Cancel");
        assertThat(window.isShowing("editor")).isTrue();
        closeEditor();
        awaitDialogAndPush("Unsaved Script", "Save");
        window.await("the editor to close", () -> !window.isShowing("editor"));
        assertThat(file).hasContent("1 move 30\n1 stop");
    }

    @Test
    void unsavedChangesAreAskedForBeforeTheProgramEnds() throws IOException {
        Path file = script("lap.majic", "1 move 30");
        RSyntaxTextArea area = drop(file);
        window.run(() -> area.append("\n1 stop"));
        window.run(window.frame::quit);
        window.awaitDialog("Unsaved Script");
        assertThat(window.quits).hasValue(0);
        window.push("Don't save");
        window.await("the end", () -> window.quits.get() == 1);
        assertThat(file).hasContent("1 move 30");
    }

    @Test
    void aNewScriptIsSavedUnderTheNameThatIsChosen() {
        window.run(() -> window.frame.getJMenuBar().getMenu(0).getItem(0).doClick());
        RSyntaxTextArea area = window.awaitShowing("script", RSyntaxTextArea.class);
        window.focus(area);
        window.run(() -> area.setText("1 stop\n"));
        window.pressWithCtrl(KeyEvent.VK_S);
        window.chooseFile(folder.resolve("mine"));
        window.await("its name", () -> isTitle(0, "mine.majic"));
        assertThat(folder.resolve("mine.majic")).hasContent("1 stop\n");
    }

    @Test
    void aChangeByAnotherProgramIsShownAndCanBeLoaded() throws IOException {
        Path file = script("lap.majic", "1 move 30");
        RSyntaxTextArea area = drop(file);
        Files.writeString(file, "1 move 40");
        window.await("the notice", () -> window.isShowing("fileNotice"));
        window.push("loadChanged");
        window.await("the new text", () -> area.getText().equals("1 move 40"));
        assertThat(window.isShowing("fileNotice")).isFalse();
    }

    @Test
    void aFileThatAnotherProgramChangedIsOverwrittenOnlyOnceThatWasAgreedTo() throws IOException {
        Path file = script("lap.majic", "1 move 30");
        RSyntaxTextArea area = drop(file);
        window.run(() -> area.append("\n1 stop"));
        Files.writeString(file, "1 move 40");
        window.pressWithCtrl(KeyEvent.VK_S);
        awaitDialogAndPush("MAJIC asks", "No");
        assertThat(file).hasContent("1 move 40");
        window.pressWithCtrl(KeyEvent.VK_S);
        awaitDialogAndPush("MAJIC asks", "Overwrite");
        window.await("the file", () -> isTitle(0, "lap.majic"));
        assertThat(file).hasContent("1 move 30\n1 stop");
    }

    @Test
    void theMenuOffersTheScriptsThatWereOpenedLast() throws IOException {
        Path first = script("first.majic", "1 stop");
        drop(first);
        drop(script("second.majic", "1 stop"));
        window.await(
                "both to be stored",
                () -> window.settings
                        .get("editor.recent")
                        .filter(stored -> stored.lines().count() == 2)
                        .isPresent());
        closeEditor();
        window.await("the editor to close", () -> !window.isShowing("editor"));
        JMenu recent = (JMenu) window.frame.getJMenuBar().getMenu(0).getItem(2);
        window.run(() -> recent.setSelected(true));
        assertThat(recent.getItem(1).getToolTipText()).isEqualTo(first.toString());
        window.run(() -> recent.getItem(1).doClick());
        window.await("the script", () -> isTitle(0, "first.majic"));
    }

    @Test
    void aFileCanBeDroppedOnTheTextsOfTheWindowToo() throws IOException {
        Path file = script("lap.majic", "1 move 30");
        for (String name : List.of("messages", "commandLine")) {
            JComponent text = window.find(name, JComponent.class);
            window.await(name + " to accept files", () -> text.getTransferHandler() instanceof FileDrop);
            TransferSupport files = new TransferSupport(text, new DraggedFile(file));
            assertThat(text.getTransferHandler().canImport(files)).isTrue();
            assertThat(text.getDropTarget().isActive()).isTrue();
        }
    }

    @Test
    void aFileThatCannotBeOpenedIsReported() {
        JRootPane pane = window.frame.getRootPane();
        window.await("the window to accept files", () -> pane.getTransferHandler() instanceof FileDrop);
        TransferSupport files = new TransferSupport(pane, new DraggedFile(folder.resolve("none.majic")));
        window.run(() -> pane.getTransferHandler().importData(files));
        window.await("the reason", () -> window.isShowing("fileNotice"));
        assertThat(window.text("fileNotice")).endsWith("none.majic: there is no such file");
    }

    @Test
    void theColoursFollowTheLookAndTheFontStays() throws IOException {
        RSyntaxTextArea area = drop(script("lap.majic", "1 move 30"));
        Font font = area.getFont();
        Color light = area.getBackground();
        window.run(() -> LookAndFeels.change(true, window.settings));
        window.await("a dark text", () -> area.getBackground().getRed() < 128);
        assertThat(area.getFont()).isEqualTo(font);
        window.run(() -> LookAndFeels.change(false, window.settings));
        window.await("a light text", () -> area.getBackground().equals(light));
    }

    @Test
    void wordsAreCompletedWhileTheyAreTyped() throws IOException {
        window.add("one");
        RSyntaxTextArea area = drop(script("lap.majic", ""));
        window.type("1 tu");
        awaitCompletions(true);
        window.press(KeyEvent.VK_ENTER);
        assertThat(area.getText()).isEqualTo("1 turn");
        window.type(" 9");
        window.press(KeyEvent.VK_ENTER);
        assertThat(area.getText()).isEqualTo("1 turn 9\n");
    }

    @Test
    void theWordsAtTheCaretAndUnderTheMouseAreExplained() throws IOException {
        window.add("one");
        RSyntaxTextArea area = drop(script("lap.majic", "1 turn 90", ""));
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
    void escClosesTheCompletionsAndStopsOnlyThen() throws IOException {
        ToyBot bot = window.add("one");
        drop(script("lap.majic", ""));
        window.type("1 tu");
        awaitCompletions(true);
        window.press(KeyEvent.VK_ESCAPE);
        awaitCompletions(false);
        assertThat(bot.told).isEmpty();
        window.press(KeyEvent.VK_ESCAPE);
        window.await("the stop", () -> bot.told.contains("halt"));
    }

    @Test
    void theNamesOfTheScriptsArgumentsAreCompleted() throws IOException {
        RSyntaxTextArea area = drop(script("lap.majic", "argument far = 300mm", ""));
        window.pressWithCtrl(KeyEvent.VK_END);
        window.type("me move $");
        awaitCompletions(true);
        window.press(KeyEvent.VK_ENTER);
        window.await("the name", () -> area.getText().contains("me move $far"));
    }

    private void awaitCompletions(boolean open) {
        window.await(
                "the completions",
                () -> open
                        == Stream.of(Window.getWindows())
                                .anyMatch(found -> found.isShowing()
                                        && found.getClass().getSimpleName().startsWith("AutoComplete")));
    }

    @Test
    void aTextIsFoundAndEscClosesTheBar() throws IOException {
        ToyBot bot = window.add("one");
        RSyntaxTextArea area = drop(script("lap.majic", "1 move 30", "1 turn 30", "1 stop"));
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
    void everythingHasANameAndEveryEntryAMnemonic() throws IOException {
        drop(script("lap.majic", "1 move 30"));
        awaitStatus("1 mistake");
        window.pressWithCtrl(KeyEvent.VK_F);
        window.awaitShowing("find", JTextField.class);
        JFrame editor = window.find("editor", JFrame.class);
        window.run(() -> {
            assertThat(WindowAudit.nameless(editor)).isEmpty();
            assertThat(WindowAudit.mnemonicProblems(editor.getJMenuBar())).isEmpty();
            assertThat(WindowAudit.pale(editor, Contrast.TEXT)).isEmpty();
        });
    }

    @Test
    void aSavedSessionIsOpenedIfThatIsChosen() {
        window.add("one");
        window.command("1 move 30");
        window.awaitMessage("done");
        window.click("Save Session");
        window.click("offer");
        window.chooseFile(folder.resolve("lap.majic"));
        window.await("the session in the editor", () -> isTitle(0, "lap.majic"));
        assertThat(window.awaitShowing("script", RSyntaxTextArea.class).getText())
                .contains("1 move 30");
    }

    @Test
    void anActIsMadeOfAScript() throws IOException {
        Path file = script("square.majic", "me move 30");
        drop(file);
        window.run(() -> window.find("editor", JFrame.class)
                .getJMenuBar()
                .getMenu(0)
                .getItem(7)
                .doClick());
        window.awaitDialog("Make Act");
        window.await("its name", () -> window.text("makeName").equals("square"));
        assertThat(window.text("makeFrom")).isEqualTo(file.toString());
    }

    /** Holds one dragged file. */
    private record DraggedFile(Path file) implements Transferable {
        @Override
        public DataFlavor[] getTransferDataFlavors() {
            return new DataFlavor[] {DataFlavor.javaFileListFlavor};
        }

        @Override
        public boolean isDataFlavorSupported(DataFlavor flavor) {
            return flavor.equals(DataFlavor.javaFileListFlavor);
        }

        @Override
        public Object getTransferData(DataFlavor flavor) {
            return List.of(file.toFile());
        }
    }

    private void awaitHalt(ToyBot bot) {
        window.await(
                "the robot to halt",
                () -> List.copyOf(bot.told).lastIndexOf("halt") == bot.told.size() - 1 && !bot.told.isEmpty());
    }
}
