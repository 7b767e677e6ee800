package majic.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Locale;
import java.util.MissingResourceException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class TextsTest {
    private final Locale before = Locale.getDefault();
    private final Texts texts = Texts.of(TextsTest.class);

    @AfterEach
    void setLanguageBack() {
        Locale.setDefault(before);
    }

    private static void speak(String tag) {
        Locale.setDefault(Locale.forLanguageTag(tag));
    }

    @Test
    void aTextIsInTheUsersLanguage() {
        speak("de-AT");
        assertThat(texts.get("greeting")).isEqualTo("Grüß Gott, Roboter");
    }

    @Test
    void aLanguageWithoutBundleGetsEnglish() {
        speak("fr");
        assertThat(texts.get("greeting")).isEqualTo("It's a robot");
    }

    @Test
    void valuesStandInTheirPlacesAndNumbersHaveNoSeparators() {
        speak("de");
        assertThat(texts.get("port", "host", 54000)).isEqualTo("Anschluss 54000 von host");
    }

    @Test
    void aTextMayDependOnANumber() {
        speak("en");
        assertThat(texts.get("robots", 1)).isEqualTo("one robot");
        assertThat(texts.get("robots", 12)).isEqualTo("12 robots");
    }

    @Test
    void aMissingTextIsAMistakeOfTheProgram() {
        assertThatThrownBy(() -> texts.get("nothing"))
                .isInstanceOf(MissingResourceException.class)
                .hasMessageContaining("nothing");
    }
}
