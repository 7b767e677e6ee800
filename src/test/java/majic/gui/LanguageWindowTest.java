package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.UIManager;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

@Tag("jdk")
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
