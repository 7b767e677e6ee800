package majic.gui.editor;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JRootPane;
import javax.swing.TransferHandler.TransferSupport;
import majic.gui.TestWindow;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests how scripts get from files into the editor and back. */
class ScriptFileWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    private final TestEditor editor;

    ScriptFileWindowTest(@TempDir Path folder) {
        editor = new TestEditor(window, folder);
    }

    @Test
    void unsavedChangesAreAskedForBeforeTheEditorCloses() throws IOException {
        Path file = editor.script("lap.majic", "1 move 30");
        RSyntaxTextArea area = editor.drop(file);
        window.run(() -> area.append("\n1 stop"));
        editor.close();
        awaitDialogAndPush("Unsaved Script", "Cancel");
        assertThat(window.isShowing("editor")).isTrue();
        editor.close();
        awaitDialogAndPush("Unsaved Script", "Save");
        window.await("the editor to close", () -> !window.isShowing("editor"));
        assertThat(file).hasContent("1 move 30\n1 stop");
    }

    @Test
    void unsavedChangesAreAskedForBeforeTheProgramEnds() throws IOException {
        Path file = editor.script("lap.majic", "1 move 30");
        RSyntaxTextArea area = editor.drop(file);
        window.run(() -> area.append("\n1 stop"));
        window.run(window.frame()::quit);
        window.awaitDialog("Unsaved Script");
        assertThat(window.quits).hasValue(0);
        window.push("Don't save");
        window.await("the end", () -> window.quits.get() == 1);
        assertThat(file).hasContent("1 move 30");
    }

    private void writeNew(String text) {
        window.run(() -> window.frame().getJMenuBar().getMenu(0).getItem(0).doClick());
        RSyntaxTextArea area = window.awaitShowing("script", RSyntaxTextArea.class);
        window.focus(area);
        window.run(() -> area.setText(text));
        window.pressWithCtrl(KeyEvent.VK_S);
    }

    @Test
    void aNewScriptIsSavedUnderTheNameThatIsChosen() {
        writeNew("1 stop\n");
        window.chooseFile(editor.file("mine"));
        window.await("its name", () -> editor.isTitle(0, "mine.majic"));
        assertThat(editor.file("mine.majic")).hasContent("1 stop\n");
    }

    @Test
    void theDialogKeepsTheTypedFolderAfterASaveThatFailed() {
        writeNew("1 stop\n");
        Path missing = editor.file("missing").resolve("mine.majic");
        window.chooseFile(missing);
        window.await("the reason", () -> window.text("fileProblem").contains("cannot be written"));
        assertThat(window.isShowing("files")).isTrue();
        assertThat(window.fileName()).isEqualTo(missing.toString());
        assertThat(editor.isTitle(0, "mine.majic")).isFalse();
    }

    @Test
    void aFileIsNotOverwrittenUnaskedWhenItsEndingIsAdded() throws IOException {
        Path file = editor.script("mine.majic", "1 move 30");
        writeNew("1 stop\n");
        window.chooseFile(editor.file("mine"));
        awaitDialogAndPush("MAJIC asks", "No");
        assertThat(file).hasContent("1 move 30");
    }

    @Test
    void aChangeByAnotherProgramIsShownAndCanBeLoaded() throws IOException {
        Path file = editor.script("lap.majic", "1 move 30");
        RSyntaxTextArea area = editor.drop(file);
        Files.writeString(file, "1 move 40");
        window.await("the notice", () -> window.isShowing("fileNotice"));
        window.push("loadChanged");
        window.await("the new text", () -> area.getText().equals("1 move 40"));
        assertThat(window.isShowing("fileNotice")).isFalse();
    }

    @Test
    void aFileThatAnotherProgramChangedIsOverwrittenOnlyOnceThatWasAgreedTo() throws IOException {
        Path file = editor.script("lap.majic", "1 move 30");
        RSyntaxTextArea area = editor.drop(file);
        window.run(() -> area.append("\n1 stop"));
        Files.writeString(file, "1 move 40");
        window.pressWithCtrl(KeyEvent.VK_S);
        awaitDialogAndPush("MAJIC asks", "No");
        assertThat(file).hasContent("1 move 40");
        window.pressWithCtrl(KeyEvent.VK_S);
        awaitDialogAndPush("MAJIC asks", "Overwrite");
        window.await("the file", () -> editor.isTitle(0, "lap.majic"));
        assertThat(file).hasContent("1 move 30\n1 stop");
    }

    @Test
    void theMenuOffersTheScriptsThatWereOpenedLast() throws IOException {
        Path first = editor.script("first.majic", "1 stop");
        editor.drop(first);
        editor.open("second.majic", "1 stop");
        window.await(
                "both to be stored",
                () -> window.settings
                        .get("editor.recent")
                        .filter(stored -> stored.lines().count() == 2)
                        .isPresent());
        editor.close();
        window.await("the editor to close", () -> !window.isShowing("editor"));
        JMenu recent = (JMenu) window.frame().getJMenuBar().getMenu(0).getItem(2);
        window.run(() -> recent.setSelected(true));
        assertThat(recent.getItem(1).getToolTipText()).isEqualTo(first.toString());
        window.run(() -> recent.getItem(1).doClick());
        window.await("the script", () -> editor.isTitle(0, "first.majic"));
    }

    @Test
    void aFileCanBeDroppedOnTheTextsOfTheWindowToo() throws IOException {
        Path file = editor.script("lap.majic", "1 move 30");
        for (String name : List.of("messages", "commandLine")) {
            JComponent text = window.find(name, JComponent.class);
            TransferSupport files = editor.dragOver(text, file);
            assertThat(text.getTransferHandler().canImport(files)).isTrue();
            assertThat(text.getDropTarget().isActive()).isTrue();
        }
    }

    @Test
    void aFileThatCannotBeOpenedIsReported() {
        JRootPane pane = window.frame().getRootPane();
        TransferSupport files = editor.dragOver(pane, editor.file("none.majic"));
        window.run(() -> pane.getTransferHandler().importData(files));
        window.await("the reason", () -> window.isShowing("fileNotice"));
        assertThat(window.text("fileNotice")).endsWith("none.majic: there is no such file");
    }

    @Test
    void aSavedSessionIsOpenedIfThatIsChosen() {
        window.add("one");
        window.command("1 move 30");
        window.awaitMessage("done");
        window.click("Save Session");
        window.click("offer");
        window.chooseFile(editor.file("lap.majic"));
        window.await("the session in the editor", () -> editor.isTitle(0, "lap.majic"));
        assertThat(window.awaitShowing("script", RSyntaxTextArea.class).getText())
                .contains("1 move 30");
    }

    @Test
    void anActIsMadeOfAScript() throws IOException {
        Path file = editor.script("square.majic", "me move 30");
        editor.drop(file);
        window.run(() -> editor.frame().getJMenuBar().getMenu(0).getItem(7).doClick());
        window.awaitDialog("Make Act");
        window.await("its name", () -> window.text("makeName").equals("square"));
        assertThat(window.text("makeFrom")).isEqualTo(file.toString());
    }

    private void awaitDialogAndPush(String dialog, String button) {
        window.awaitDialog(dialog);
        window.push(button);
    }
}
