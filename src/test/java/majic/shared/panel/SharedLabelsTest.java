package majic.shared.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class SharedLabelsTest {
    private final Locale before = Locale.getDefault();

    @AfterEach
    void restoreTheLanguage() {
        Locale.setDefault(before);
    }

    @Test
    void theLabelsAreInTheUsersLanguage() {
        Locale.setDefault(Locale.ENGLISH);
        assertThat(SharedLabels.of("distanceFront")).isEqualTo("distance front");
        Locale.setDefault(Locale.GERMAN);
        assertThat(SharedLabels.of("distanceFront")).isEqualTo("Abstand vorn");
    }

    @Test
    void aParameterOfAnotherMakeHasItsNameInWords() {
        assertThat(SharedLabels.of("oilPressure")).isEqualTo("oil pressure");
    }
}
