package majic.gui.bots;

import static org.assertj.core.api.Assertions.assertThat;

import javax.swing.JPasswordField;
import javax.swing.JTextField;
import majic.gui.TestWindow;
import majic.gui.kit.RobotSharing.Place;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Tests the dialog that shares the robots with other desks. */
class ShareWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    private void share(String broker) {
        window.run(() -> window.entry("Share the Robots…").doClick(0));
        window.awaitDialog("Share the Robots");
        window.run(() -> window.find("shareBroker", JTextField.class).setText(broker));
        window.push("shareBegin");
    }

    @Test
    void theRobotsAreSharedUnderTheSuggestedNames() {
        share("mqtt://broker/lab");

        window.await("the addresses", () -> window.text("shareState").contains("mqtt://broker/lab/desk1/1"));
        assertThat(window.sharing.now()).contains(new Place("mqtt://broker/lab", "desk1", "Anna"));
        assertThat(window.isEnabled("shareBegin")).isFalse();
    }

    @Test
    void aBrokerThatCannotBeReachedIsNamedAndTheDialogStaysOpen() {
        share("mqtt://nowhere/lab");

        window.await("the reason", () -> window.text("shareState").equals("there is no computer of the name nowhere"));
        window.await("another attempt to be possible", () -> window.isEnabled("shareBegin"));
        assertThat(window.isEnabled("shareEnd")).isFalse();
    }

    @Test
    void aMissingBrokerIsAskedFor() {
        share(" ");

        window.await("the request", () -> window.text("shareState").startsWith("Fill in the broker"));
        window.await("the focus", window.find("shareBroker", JTextField.class)::isFocusOwner);
        assertThat(window.sharing.now()).isEmpty();
        assertThat(window.isEnabled("shareBegin")).isTrue();
    }

    @Test
    void aBrokerThatRefusesTheUserIsTriedAgainWithAnother() {
        share("mqtt://strict/lab");
        window.awaitDialog("User and Password");

        window.run(() -> {
            window.find("loginUser", JTextField.class).setText("anna");
            window.find("loginPassword", JPasswordField.class).setText("secret");
        });
        window.push("loginOk");

        window.await("the addresses", () -> window.text("shareState").contains("mqtt://strict/lab/desk1/1"));
    }

    @Test
    void aLostConnectionIsShown() {
        share("mqtt://broker/lab");
        window.await("the end to be possible", () -> window.isEnabled("shareEnd"));

        window.sharing.lose();

        window.await("the loss", () -> window.text("shareState").contains("is lost; it is being made again"));
    }

    @Test
    void endingTheSharingIsShown() {
        share("mqtt://broker/lab");
        window.await("the end to be possible", () -> window.isEnabled("shareEnd"));

        window.push("shareEnd");

        window.await("the end", () -> window.text("shareState").contains("not shared any more"));
        assertThat(window.sharing.now()).isEmpty();
    }

    @Test
    void cardAndStatusLineShowTheRemoteHolder() {
        window.add("a").holdBy("Carl at desk3");

        window.await("the tab", () -> window.text("tabActivity1").equals("held by Carl at desk3"));
        window.await("the status line", () -> window.text("condition1").endsWith(", held by Carl at desk3"));
    }
}
