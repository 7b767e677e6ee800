package majic.gui.help;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Optional;
import javax.swing.JEditorPane;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.MenuSelectionManager;
import javax.swing.text.Element;
import javax.swing.text.Utilities;
import majic.gui.TestWindow;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

class HelpWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    @Test
    void f1OpensTheHelpWhoseSearchShowsOnlyTheRowsWithTheText() {
        window.focus("commandLine");
        window.press(KeyEvent.VK_F1);
        window.awaitDialog("Help");
        JTable commands = window.find("help commands", JTable.class);
        window.await("the commands", () -> commands.getRowCount() > 0);
        int all = commands.getRowCount();
        window.write("helpSearch", "CURVE");
        window.await("the search", () -> commands.getRowCount() < all);
        assertThat(commands.getValueAt(0, 0)).asString().startsWith("1 drive");
    }

    @Test
    void rowsThatComeAfterTheTextWasTypedAreSearchedToo() {
        window.run(() -> {
            HelpDialog dialog = new HelpDialog(window.frame, List.of(), Optional.empty());
            window.find("helpSearch", JTextField.class).setText("CURVE");
            dialog.setVisible(true);
        });
        JTable commands = window.awaitShowing("help commands", JTable.class);
        window.await("the rows with the text", () -> commands.getRowCount() > 0);
        assertThat(commands.getRowCount()).isLessThan(commands.getModel().getRowCount());
    }

    @Test
    void theGuideIsPartOfTheProgramAndCanBeSearched() {
        window.run(() -> window.entry("Guide").doClick());
        window.awaitDialog("Help");
        window.await("the guide", () -> window.text("guide user-guide").contains("The main screen"));
        window.write("helpSearch", "KILL MAJIC");
        window.await("the part", () -> !window.text("guide user-guide").contains("The main screen"));
        assertThat(window.text("guide user-guide")).contains("Quitting");
    }

    @Test
    void f1InADialogShowsTheSectionOfTheGuideAboutIt() {
        window.run(window.frame::addBot);
        window.awaitDialogWithKeys("Add Bot");
        window.press(KeyEvent.VK_F1);
        window.awaitDialog("Help");
        JEditorPane guide = window.awaitShowing("guide user-guide", JEditorPane.class);
        window.await("the section", () -> topLine(guide).equals("Adding a robot"));
    }

    /** Returns the line of text at the upper edge of what is visible. */
    private static String topLine(JEditorPane page) {
        return GuiActionRunner.execute(() -> {
            int first = page.viewToModel2D(new Point(0, page.getVisibleRect().y + 2));
            Element line = Utilities.getParagraphElement(page, first);
            return page.getText(line.getStartOffset(), line.getEndOffset() - line.getStartOffset())
                    .strip();
        });
    }

    @Test
    void aLetterThatChoosesAMenuEntryIsNotTypedIntoTheCommandLine() {
        window.focus("commandLine");
        window.pressWithAlt(KeyEvent.VK_H);
        window.await("the menu", () -> MenuSelectionManager.defaultManager().getSelectedPath().length > 0);
        window.press(KeyEvent.VK_A);
        window.awaitDialog("About MAJIC");
        assertThat(window.text("commandLine")).isEmpty();
    }
}
