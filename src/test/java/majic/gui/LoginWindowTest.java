package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import javax.swing.JPasswordField;
import javax.swing.JTextField;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests the question for the user name and the password of a broker that refuses those it was given. */
class LoginWindowTest {
    private static final String TITLE = "User and Password";

    @AutoClose
    private final TestWindow window = TestWindow.open();

    @BeforeEach
    void requireAPassword() {
        window.type.unlockedIf(window.sharing::isAnna);
    }

    private void answer(String user, String password) {
        JTextField name = window.awaitShowing("loginUser", JTextField.class);
        JPasswordField secret = window.awaitShowing("loginPassword", JPasswordField.class);
        window.run(() -> {
            name.setText(user);
            secret.setText(password);
        });
        window.push("loginOk");
    }

    private void awaitCards(String... numbers) {
        window.await("the tabs", () -> window.tabs().equals(List.of(numbers)));
    }

    @Test
    void aTypedLineIsExecutedAgainWithThePassword() {
        window.command("add toy://strict/lab/desk2/1 as 7");
        answer("anna", "secret");

        awaitCards("7");
        assertThat(window.text("messages")).doesNotContain("secret");
    }

    @Test
    void aWrongPasswordIsAskedForAgain() {
        window.command("add toy://strict/lab/desk2/1");
        answer("anna", "guessed");
        answer("anna", "secret");

        awaitCards("1");
    }

    @Test
    void severalRobotsOfABrokerNeedOneAnswer() {
        window.command("add toy://strict/lab/desk2/1 as 1");
        window.awaitDialogWithKeys(TITLE);
        window.command("add toy://strict/lab/desk2/2 as 2");
        window.await("both refusals", () -> window.text("messages").split("refuses the user name", -1).length == 3);
        answer("anna", "secret");

        awaitCards("1", "2");
        assertThat(window.isShowing(TITLE + " dialog")).isFalse();
    }

    @Test
    void aStopThatIsTypedAsTheUserStopsTheTeam() {
        window.add("rolling");
        window.command("add toy://strict/lab/desk2/1");
        answer("all stop", "");

        window.await("the STOP", window::isStopLatched);
        assertThat(window.isShowing(TITLE + " dialog")).isTrue();
    }

    @Test
    void theAddDialogConnectsAgainWithThePassword() {
        window.click("Add Bot");
        window.awaitDialog("Add Bot");
        window.write("host", "strict");
        window.push("OK");
        answer("anna", "secret");

        awaitCards("1");
    }
}
