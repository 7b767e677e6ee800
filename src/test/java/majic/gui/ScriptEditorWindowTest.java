package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Dialog;
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
import org.assertj.swing.edt.GuiActionRunner;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rsyntaxtextarea.parser.ParserNotice;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** One window is opened for all tests, since that takes longer than a test. */
@Timeout(60)
class ScriptEditorWindowTest {
    @AutoClose
    private static final TestWindow WINDOW = TestWindow.open();

    @TempDir
    private Path folder;

    @AfterEach
    void closeScriptsAndRemoveRobots() {
        WINDOW.run(() ->
                Stream.of(Window.getWindows()).filter(Dialog.class::isInstance).forEach(Window::dispose));
        if (WINDOW.isShowing("editor")) {
            closeEditor();
            WINDOW.await("the editor to close", this::isClosed);
        }
        WINDOW.run(() -> {
            WINDOW.team.members().forEach(member -> WINDOW.team.remove(member.number()));
            WINDOW.team.release();
        });
        WINDOW.await("no cards", () -> WINDOW.cards().isEmpty());
    }

    /** Answers the questions before scripts are closed. */
    private boolean isClosed() {
        Stream.of("End and close", "Don't save").filter(WINDOW::isShowing).forEach(WINDOW::push);
        return !WINDOW.isShowing("editor");
    }

    private Path script(String name, String... lines) throws IOException {
        return Files.writeString(folder.resolve(name), String.join("\n", lines));
    }

    /** Drops a file on the main window, and waits until it is in the editor. */
    private RSyntaxTextArea drop(Path file) {
        JRootPane pane = WINDOW.frame.getRootPane();
        WINDOW.await("the window to accept files", () -> pane.getTransferHandler() instanceof FileDrop);
        TransferSupport files = new TransferSupport(pane, new DraggedFile(file));
        WINDOW.run(() -> {
            assertThat(pane.getTransferHandler().canImport(files)).isTrue();
            pane.getTransferHandler().importData(files);
        });
        String name = file.getFileName().toString();
        WINDOW.await(name + " in the editor", () -> isTitle(0, name) || isTitle(1, name));
        RSyntaxTextArea area = WINDOW.awaitShowing("script", RSyntaxTextArea.class);
        WINDOW.focus(area);
        return area;
    }

    private boolean isTitle(int index, String name) {
        if (!WINDOW.isShowing("scripts")) {
            return false;
        }
        JTabbedPane tabs = WINDOW.find("scripts", JTabbedPane.class);
        return index < tabs.getTabCount() && tabs.getTitleAt(index).endsWith(name);
    }

    private void awaitStatus(String status) {
        WINDOW.await(
                "the status \"" + status + "\"",
                () -> WINDOW.text("scriptStatus").startsWith(status));
    }

    private void awaitDialogAndPush(String dialog, String button) {
        WINDOW.awaitDialog(dialog);
        WINDOW.push(button);
    }

    private void closeEditor() {
        JFrame editor = WINDOW.find("editor", JFrame.class);
        WINDOW.run(() -> editor.dispatchEvent(new WindowEvent(editor, WindowEvent.WINDOW_CLOSING)));
    }

    @Test
    @Tag("jdk")
    void aScriptDroppedOnTheWindowShowsItsRobotsAndRuns() throws IOException {
        ToyBot bot = WINDOW.add("one", 1);
        drop(script("lap.majic", "1 move 30", "1 turn 20"));
        awaitStatus("No mistakes");
        assertThat(WINDOW.text("scriptRobots")).isEqualTo("1 Toy");
        WINDOW.press(KeyEvent.VK_F5);
        awaitStatus("Last run: done");
        assertThat(bot.told).containsExactly("move 30", "turn 20");
        WINDOW.awaitMessage("run lap.majic: done");
    }

    @Test
    void mistakesAreUnderlinedAndListedWithTheirReasons() throws IOException {
        WINDOW.add("one", 1);
        RSyntaxTextArea area = drop(script("lap.majic", "1 move 30", "1 mvoe 3"));
        awaitStatus("1 mistake");
        ParserNotice notice = area.getParserNotices().get(0);
        assertThat(notice.getMessage()).contains("did you mean move?");
        assertThat(area.getText().substring(notice.getOffset(), notice.getOffset() + notice.getLength()))
                .isEqualTo("mvoe");
        JList<?> list = WINDOW.awaitShowing("mistakes", JList.class);
        WINDOW.run(() -> list.setSelectedIndex(0));
        WINDOW.focus(list);
        WINDOW.press(KeyEvent.VK_ENTER);
        assertThat(area.getCaretPosition()).isEqualTo(notice.getOffset());
        WINDOW.run(() -> area.replaceRange("move", notice.getOffset(), notice.getOffset() + 4));
        awaitStatus("No mistakes");
        assertThat(WINDOW.isShowing("mistakes")).isFalse();
    }

    @Test
    void aScriptIsCheckedAgainWhenARobotIsAdded() throws IOException {
        drop(script("lap.majic", "1 move 30"));
        awaitStatus("1 mistake");
        WINDOW.add("one", 1);
        awaitStatus("No mistakes");
    }

    @Test
    void aScriptIsRunLineByLine() throws IOException {
        ToyBot bot = WINDOW.add("one", 1);
        RSyntaxTextArea area = drop(script("lap.majic", "# a lap", "1 move 30", "1 move 40", "1 move 50"));
        awaitStatus("No mistakes");
        WINDOW.press(KeyEvent.VK_F7);
        awaitStatus("Paused before line 2");
        assertThat(area.isEditable()).isFalse();
        WINDOW.press(KeyEvent.VK_F7);
        awaitStatus("Paused before line 3");
        assertThat(bot.told).containsExactly("move 30");
        WINDOW.press(KeyEvent.VK_F5);
        awaitStatus("Last run: done");
        assertThat(bot.told).containsExactly("move 30", "move 40", "move 50");
        assertThat(area.isEditable()).isTrue();
    }

    @Test
    void theSelectedLinesRunAlone() throws IOException {
        ToyBot bot = WINDOW.add("one", 1);
        RSyntaxTextArea area = drop(script("lap.majic", "1 move 30", "1 move 40", "1 move 50"));
        awaitStatus("No mistakes");
        WINDOW.run(
                () -> area.select(area.getText().indexOf("40"), area.getText().indexOf("50")));
        WINDOW.pressWithCtrl(KeyEvent.VK_F5);
        awaitStatus("Last run: done");
        assertThat(bot.told).containsExactly("move 40", "move 50");
        WINDOW.awaitMessage("run lap.majic (lines 2 to 3): done");
    }

    @Test
    void theKeysForStopWorkInTheEditor() throws IOException {
        ToyBot bot = WINDOW.add("one", 1);
        drop(script("lap.majic", "1 move 30", "wait 100s"));
        awaitStatus("No mistakes");
        WINDOW.press(KeyEvent.VK_F5);
        awaitStatus("Running line 2");
        WINDOW.press(KeyEvent.VK_ESCAPE);
        awaitStatus("Last run: stopped");
        assertThat(bot.told).endsWith("halt");
        WINDOW.await("STOP in the editor", () -> WINDOW.text("smallStop").equals("STOPPED"));
        WINDOW.run(WINDOW.team::release);
        WINDOW.press(KeyEvent.VK_F12);
        assertThat(WINDOW.team.isLatched()).isTrue();
    }

    @Test
    void endStopsTheScriptAndNotTheOtherRobots() throws IOException {
        ToyBot bot = WINDOW.add("one", 1);
        ToyBot other = WINDOW.add("two", 2);
        drop(script("lap.majic", "1 move 30", "wait 100s"));
        awaitStatus("No mistakes");
        WINDOW.press(KeyEvent.VK_F5);
        awaitStatus("Running line 2");
        WINDOW.push("editor End");
        awaitStatus("Last run: stopped");
        assertThat(bot.told).endsWith("halt");
        assertThat(other.told).isEmpty();
        assertThat(WINDOW.team.isLatched()).isFalse();
    }

    @Test
    void unsavedChangesAreAskedForBeforeTheEditorCloses() throws IOException {
        Path file = script("lap.majic", "1 move 30");
        RSyntaxTextArea area = drop(file);
        WINDOW.run(() -> area.append("\n1 stop"));
        closeEditor();
        awaitDialogAndPush("Unsaved Script", "Cancel");
        assertThat(WINDOW.isShowing("editor")).isTrue();
        closeEditor();
        awaitDialogAndPush("Unsaved Script", "Save");
        WINDOW.await("the editor to close", () -> !WINDOW.isShowing("editor"));
        assertThat(file).hasContent("1 move 30\n1 stop");
    }

    @Test
    void aNewScriptIsSavedUnderTheNameThatIsChosen() {
        WINDOW.run(() -> WINDOW.frame.getJMenuBar().getMenu(0).getItem(0).doClick());
        RSyntaxTextArea area = WINDOW.awaitShowing("script", RSyntaxTextArea.class);
        WINDOW.focus(area);
        WINDOW.run(() -> area.setText("1 stop\n"));
        WINDOW.pressWithCtrl(KeyEvent.VK_S);
        WINDOW.chooseFile(folder.resolve("mine"));
        WINDOW.await("its name", () -> isTitle(0, "mine.majic"));
        assertThat(folder.resolve("mine.majic")).hasContent("1 stop\n");
    }

    @Test
    void aChangeByAnotherProgramIsShownAndCanBeLoaded() throws IOException {
        Path file = script("lap.majic", "1 move 30");
        RSyntaxTextArea area = drop(file);
        Files.writeString(file, "1 move 40");
        WINDOW.await("the notice", () -> WINDOW.isShowing("fileNotice"));
        WINDOW.push("loadChanged");
        WINDOW.await("the new text", () -> area.getText().equals("1 move 40"));
        assertThat(WINDOW.isShowing("fileNotice")).isFalse();
    }

    @Test
    void aFileThatAnotherProgramChangedIsOverwrittenOnlyOnceThatWasAgreedTo() throws IOException {
        Path file = script("lap.majic", "1 move 30");
        RSyntaxTextArea area = drop(file);
        WINDOW.run(() -> area.append("\n1 stop"));
        Files.writeString(file, "1 move 40");
        WINDOW.pressWithCtrl(KeyEvent.VK_S);
        awaitDialogAndPush("MAJIC asks", "No");
        assertThat(file).hasContent("1 move 40");
        WINDOW.pressWithCtrl(KeyEvent.VK_S);
        awaitDialogAndPush("MAJIC asks", "Overwrite");
        WINDOW.await("the file", () -> isTitle(0, "lap.majic"));
        assertThat(file).hasContent("1 move 30\n1 stop");
    }

    @Test
    void theMenuOffersTheScriptsThatWereOpenedLast() throws IOException {
        Path first = script("first.majic", "1 stop");
        drop(first);
        drop(script("second.majic", "1 stop"));
        String both = folder.resolve("second.majic") + "\n" + first;
        WINDOW.await(
                "both to be stored",
                () -> WINDOW.settings
                        .get("editor.recent")
                        .filter(stored -> stored.startsWith(both))
                        .isPresent());
        closeEditor();
        WINDOW.await("the editor to close", () -> !WINDOW.isShowing("editor"));
        JMenu recent = (JMenu) WINDOW.frame.getJMenuBar().getMenu(0).getItem(2);
        WINDOW.run(() -> recent.setSelected(true));
        assertThat(recent.getItem(1).getToolTipText()).isEqualTo(first.toString());
        WINDOW.run(() -> recent.getItem(1).doClick());
        WINDOW.await("the script", () -> isTitle(0, "first.majic"));
    }

    @Test
    void aFileCanBeDroppedOnTheTextsOfTheWindowToo() throws IOException {
        Path file = script("lap.majic", "1 move 30");
        for (String name : List.of("messages", "commandLine")) {
            JComponent text = WINDOW.find(name, JComponent.class);
            WINDOW.await(name + " to accept files", () -> text.getTransferHandler() instanceof FileDrop);
            TransferSupport files = new TransferSupport(text, new DraggedFile(file));
            assertThat(text.getTransferHandler().canImport(files)).isTrue();
        }
    }

    @Test
    void aFileThatCannotBeOpenedIsReported() {
        JRootPane pane = WINDOW.frame.getRootPane();
        WINDOW.await("the window to accept files", () -> pane.getTransferHandler() instanceof FileDrop);
        TransferSupport files = new TransferSupport(pane, new DraggedFile(folder.resolve("none.majic")));
        WINDOW.run(() -> pane.getTransferHandler().importData(files));
        WINDOW.await("the reason", () -> WINDOW.isShowing("fileNotice"));
        assertThat(WINDOW.text("fileNotice")).endsWith("none.majic: there is no such file");
    }

    @Test
    void theColoursFollowTheLookAndTheFontStays() throws IOException {
        RSyntaxTextArea area = drop(script("lap.majic", "1 move 30"));
        Font font = area.getFont();
        Color light = area.getBackground();
        WINDOW.run(() -> LookAndFeels.change(true, WINDOW.settings));
        WINDOW.await("a dark text", () -> area.getBackground().getRed() < 128);
        assertThat(area.getFont()).isEqualTo(font);
        WINDOW.run(() -> LookAndFeels.change(false, WINDOW.settings));
        WINDOW.await("a light text", () -> area.getBackground().equals(light));
    }

    @Test
    void wordsAreCompletedWhileTheyAreTyped() throws IOException {
        WINDOW.add("one", 1);
        RSyntaxTextArea area = drop(script("lap.majic", ""));
        WINDOW.type("1 tu");
        awaitCompletions(true);
        WINDOW.press(KeyEvent.VK_ENTER);
        assertThat(area.getText()).isEqualTo("1 turn");
        WINDOW.type(" 9");
        WINDOW.press(KeyEvent.VK_ENTER);
        assertThat(area.getText()).isEqualTo("1 turn 9\n");
    }

    @Test
    void theWordsAtTheCaretAndUnderTheMouseAreExplained() throws IOException {
        WINDOW.add("one", 1);
        RSyntaxTextArea area = drop(script("lap.majic", "1 turn 90", ""));
        WINDOW.run(() -> area.setCaretPosition("1 tu".length()));
        assertThat(WINDOW.text("wordHint")).startsWith("turn ANGLE").contains("left positive");
        WINDOW.run(() -> area.setCaretPosition("1 turn ".length()));
        assertThat(WINDOW.text("wordHint")).isEqualTo("an angle (deg, rad)");
        WINDOW.run(() -> area.setCaretPosition(area.getText().length()));
        assertThat(WINDOW.text("wordHint")).isEmpty();
        Rectangle word = GuiActionRunner.execute(
                () -> area.modelToView2D("1 tu".length()).getBounds());
        assertThat(WINDOW.tipAt("script", new Point(word.x, word.y + 2))).startsWith("turn ANGLE");
        assertThat(WINDOW.tipAt("script", new Point(word.x + 400, word.y + 2))).isNull();
    }

    @Test
    void escClosesTheCompletionsAndStopsOnlyThen() throws IOException {
        ToyBot bot = WINDOW.add("one", 1);
        drop(script("lap.majic", ""));
        WINDOW.type("1 tu");
        awaitCompletions(true);
        WINDOW.press(KeyEvent.VK_ESCAPE);
        awaitCompletions(false);
        assertThat(bot.told).isEmpty();
        WINDOW.press(KeyEvent.VK_ESCAPE);
        WINDOW.await("the stop", () -> bot.told.contains("halt"));
    }

    private void awaitCompletions(boolean open) {
        WINDOW.await(
                "the completions",
                () -> open
                        == Stream.of(Window.getWindows())
                                .anyMatch(found -> found.isShowing()
                                        && found.getClass().getSimpleName().startsWith("AutoComplete")));
    }

    @Test
    void aTextIsFoundAndEscClosesTheBar() throws IOException {
        ToyBot bot = WINDOW.add("one", 1);
        RSyntaxTextArea area = drop(script("lap.majic", "1 move 30", "1 turn 30", "1 stop"));
        WINDOW.pressWithCtrl(KeyEvent.VK_F);
        WINDOW.awaitShowing("find", JTextField.class);
        WINDOW.focus("find");
        WINDOW.type("30");
        WINDOW.press(KeyEvent.VK_ENTER);
        WINDOW.press(KeyEvent.VK_ENTER);
        assertThat(WINDOW.text("findCount")).isEqualTo("2 found");
        assertThat(area.getSelectionStart()).isEqualTo(area.getText().lastIndexOf("30"));
        WINDOW.press(KeyEvent.VK_ESCAPE);
        WINDOW.await("the bar to close", () -> !WINDOW.isShowing("find"));
        assertThat(bot.told).isEmpty();
    }

    @Test
    void everythingHasANameAndEveryEntryAMnemonic() throws IOException {
        drop(script("lap.majic", "1 move 30"));
        awaitStatus("1 mistake");
        WINDOW.pressWithCtrl(KeyEvent.VK_F);
        WINDOW.awaitShowing("find", JTextField.class);
        JFrame editor = WINDOW.find("editor", JFrame.class);
        WINDOW.run(() -> {
            assertThat(WindowAudit.nameless(editor)).isEmpty();
            assertThat(WindowAudit.mnemonicProblems(editor.getJMenuBar())).isEmpty();
            assertThat(WindowAudit.pale(editor, Contrast.TEXT)).isEmpty();
        });
    }

    @Test
    void aSavedSessionIsOpenedIfThatIsChosen() {
        WINDOW.add("one", 1);
        WINDOW.command("1 move 77");
        WINDOW.awaitMessage("1 move 77: done");
        WINDOW.click("Save Session");
        WINDOW.click("offer");
        WINDOW.chooseFile(folder.resolve("lap.majic"));
        WINDOW.await("the session in the editor", () -> isTitle(0, "lap.majic"));
        assertThat(WINDOW.awaitShowing("script", RSyntaxTextArea.class).getText())
                .contains("1 move 77");
    }

    @Test
    void anActIsMadeOfAScript() throws IOException {
        Path file = script("square.majic", "me move 30");
        drop(file);
        WINDOW.run(() -> WINDOW.find("editor", JFrame.class)
                .getJMenuBar()
                .getMenu(0)
                .getItem(7)
                .doClick());
        WINDOW.awaitDialog("Make Act");
        WINDOW.await("its name", () -> WINDOW.text("makeName").equals("square"));
        assertThat(WINDOW.text("makeFrom")).isEqualTo(file.toString());
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
}
