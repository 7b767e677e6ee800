package majic.gui;

import java.awt.Component;
import java.awt.Dialog;
import java.awt.KeyboardFocusManager;
import java.awt.Window;
import javax.swing.JFrame;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that a dialog that has just opened can be used by keyboard without a click. */
class DialogFocusWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    @BeforeEach
    void addRobot() {
        window.add("one");
    }

    @ParameterizedTest
    @CsvSource({
        "Add Bot…,Add Bot",
        "Kill Bot…,Kill Bot",
        "Load Act…,Load Act",
        "Make Act…,Make Act",
        "Save Session…,Save Session",
        "Open…,Open Script",
        "Open Recording…,Open Recording",
        "Help,Help",
        "Tour,Tour",
        "About MAJIC,About MAJIC"
    })
    void aComponentOfTheDialogHasTheFocus(String entry, String title) {
        window.run(() -> window.entry(entry).doClick());
        Dialog dialog = window.awaitDialog(title);
        window.await("the focus in " + title, () -> {
            Component owner = focusOwner();
            return owner != null && owner != dialog && windowOf(owner) == dialog;
        });
    }

    @Test
    void whatIsTypedAfterNewPlotGoesIntoTheFieldThatFindsCurves() {
        window.run(() -> window.entry("New Plot…").doClick());
        window.awaitShowing("plot", JFrame.class);
        JTextField filter = window.awaitShowing("curveFilter", JTextField.class);
        window.await("the focus in the field", filter::isFocusOwner);
        window.type("head");
        window.await("the text", () -> window.text("curveFilter").equals("head"));
    }

    private static Component focusOwner() {
        return GuiActionRunner.execute(
                () -> KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner());
    }

    private static Window windowOf(Component component) {
        return component instanceof Window self ? self : SwingUtilities.getWindowAncestor(component);
    }
}
