package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Container;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.UIManager;
import majic.bot.ConnectFailed;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class LanguageWindowTest {
    private static final String KEY = "window.language";

    private final Locale before = Locale.getDefault();

    @AfterEach
    void setLanguageBack() {
        Language.use(before);
    }

    @Test
    void theWindowAndTheDialogsOfSwingAreInTheChosenLanguage() {
        try (TestWindow window = TestWindow.openWith(KEY, "de")) {
            assertThat(window.entry("Sprache").isEnabled()).isTrue();
            assertThat(cancelButton()).isEqualTo("Abbrechen");
        }
        try (TestWindow window = TestWindow.openWith(KEY, "en")) {
            assertThat(window.entry("Language").isEnabled()).isTrue();
            assertThat(cancelButton()).isEqualTo("Cancel");
        }
    }

    @Test
    void theReasonOfAQuestionIsInTheLanguageOfTheWindow() {
        try (TestWindow window = TestWindow.openWith(KEY, "de")) {
            window.command("add toy:one");
            window.await("the tab", () -> window.tabs().contains("1"));
            ToyBot bot = (ToyBot) window.team.member(1).bot();
            bot.refuseConnections(new ConnectFailed(
                    ConnectFailed.Reason.OTHER_ADAPTER, "the robot's controller was reset; try again"));
            bot.loseLink();
            window.await("the button", () -> window.isShowing("tabReconnect1"));
            window.click("tabReconnect1");
            assertThat(labels(window.awaitDialog("MAJIC fragt")))
                    .contains("Roboter 1: die Steuerung des Roboters wurde zurückgesetzt;");
        }
    }

    private static List<String> labels(Container in) {
        return GuiActionRunner.execute(() -> texts(in).toList());
    }

    private static Stream<String> texts(Container in) {
        return Stream.of(in.getComponents())
                .flatMap(part -> part instanceof JLabel label
                        ? Stream.of(label.getText())
                        : part instanceof Container inner ? texts(inner) : Stream.empty());
    }

    private static String cancelButton() {
        return GuiActionRunner.execute(() -> UIManager.getString("FileChooser.cancelButtonText"));
    }

    @Test
    void aLanguageIsChosenForTheNextStart() {
        try (TestWindow window = TestWindow.open()) {
            window.run(() -> window.frame.chooseLanguage(Language.GERMAN));
            window.awaitMessage("The language changes at the next start of MAJIC.");
            window.await("the choice", () -> window.settings.get(KEY).equals(Optional.of("de")));
            assertThat(window.entry("Language").isEnabled()).isTrue();
        }
    }

    @Test
    void aDamagedChoiceMeansTheLanguageOfTheComputer() {
        try (TestWindow window = TestWindow.openWith(KEY, "?")) {
            assertThat(Language.chosen(window.settings)).isEqualTo(Language.SYSTEM);
            assertThat(JComponent.getDefaultLocale()).isEqualTo(before);
        }
    }
}
