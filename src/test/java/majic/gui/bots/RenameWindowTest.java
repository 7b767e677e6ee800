package majic.gui.bots;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Container;
import java.awt.Frame;
import java.awt.event.KeyEvent;
import javax.swing.JLabel;
import javax.swing.JTextField;
import majic.gui.Contrast;
import majic.gui.TestWindow;
import majic.gui.WindowAudit;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Names of robots in the window. */
class RenameWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    @BeforeEach
    void addTwo() {
        window.add("a");
        window.add("b");
    }

    private void enter(String name) {
        window.awaitShowing("rename", Container.class);
        window.run(() -> window.find("robotName", JTextField.class).setText(name));
        window.push("OK");
    }

    private void awaitClosed() {
        window.await("the dialog to close", () -> !window.isShowing("rename"));
    }

    @Test
    void f2OnACardRenamesItsRobotInAllPlaces() {
        window.focus("tab1");
        window.press(KeyEvent.VK_F2);
        enter("Rex");
        awaitClosed();
        window.awaitMessage("1 name Rex: done");
        window.await("the tab", () -> window.text("tabName1").equals("Rex (Toy)"));
        window.await("the title", () -> window.text("title1").startsWith("Rex ("));
        window.click("tab2");
        window.command("rex turn 10");
        window.awaitMessage("1 turn 10: done");
    }

    @Test
    void aTabShowsALongNameAndAProblemThoughTheBatteryIsFull() {
        window.run(() -> window.frame.setSize(1280, 800));
        window.add("charged");
        window.team.rename(window.team.member(3), "PioneerAtDesk2");
        window.await("the name", () -> window.text("tabName3").equals("PioneerAtDesk2 (Toy)"));
        window.await("the charge", () -> window.isShowing("tabBattery3"));
        window.await("the problem", () -> window.text("tabLine3").startsWith("no report for"));

        window.await("the whole name and problem", () -> isWhole("tabName3") && isWhole("tabLine3"));
    }

    private boolean isWhole(String label) {
        JLabel shown = window.find(label, JLabel.class);
        return shown.getWidth() >= shown.getPreferredSize().width;
    }

    @Test
    void theMenuOfACardOpensTheDialogAndAnEmptyNameRemovesTheName() {
        window.team.rename(window.team.member(2), "Max");
        window.menuOf("tab2");
        window.click("rename");
        window.await(
                "the focus", () -> window.find("robotName", JTextField.class).isFocusOwner());
        assertThat(window.text("robotName")).isEqualTo("Max");
        window.press(KeyEvent.VK_DELETE);
        window.press(KeyEvent.VK_ENTER);
        awaitClosed();
        assertThat(window.team.member(2).name()).isEmpty();
    }

    @Test
    void aRefusedNameKeepsTheDialogOpenAndStopsNothing() {
        window.team.rename(window.team.member(2), "Max");
        window.focus("tab1");
        window.press(KeyEvent.VK_F2);
        enter("stop");
        window.await("the reason", () -> window.text("renameAdvice").startsWith("stop: a word of MAJIC Script"));
        enter("max");
        window.await("the reason", () -> window.text("renameAdvice").startsWith("max: robot 2 has this name"));
        assertThat(window.isStopLatched()).isFalse();
        enter("Rex");
        awaitClosed();
        assertThat(window.team.member(1).name()).isEqualTo("Rex");
    }

    @Test
    void theWindowOfARobotHasItsName() {
        window.menuOf("tab1");
        window.click("openWindow");
        Frame own = window.awaitShowing("robotWindow1", Frame.class);
        window.team.rename(window.team.member(1), "Rex");
        window.await("the title", () -> own.getTitle().startsWith("Robot 1, Rex ("));
    }

    @Test
    void aPlotHasTheNameOfTheRobotOfACurve() {
        window.team.rename(window.team.member(1), "Rex");
        window.awaitShowing("pose1", JLabel.class);
        window.focus("pose1");
        window.press(KeyEvent.VK_ENTER);
        JLabel curve = window.awaitShowing("curve 1 x (mm)", JLabel.class);
        assertThat(curve.getText()).isEqualTo("1 Rex x");
        assertThat(curve.getToolTipText()).isEqualTo("1 Rex x (mm)");
    }

    @Test
    void thePartsOfTheDialogHaveNamesAndReadableTexts() {
        window.focus("tab1");
        window.press(KeyEvent.VK_F2);
        Container dialog = window.awaitShowing("rename", Container.class);
        window.run(() -> {
            assertThat(WindowAudit.nameless(dialog)).isEmpty();
            assertThat(WindowAudit.pale(dialog, Contrast.TEXT)).isEmpty();
        });
    }
}
