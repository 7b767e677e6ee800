package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Rectangle;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WindowPlaceTest {
    private static final WindowPlace PLACE =
            new WindowPlace(new Rectangle(-20, 10, 1280, 800), true, List.of(700, 460));

    @Test
    void isReadAsItWasWritten() {
        assertThat(PLACE).hasToString("-20 10 1280 800 maximised 700 460");
        assertThat(WindowPlace.parse(PLACE.toString())).contains(PLACE);
    }

    @Test
    void aDividerThatWasNotKeptIsMissing() {
        assertThat(PLACE.divider(1)).contains(460);
        assertThat(PLACE.divider(2)).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "1 2 3", "1 2 3 4 5", "1 2 -3 4 normal", "999999 2 3 4 normal", "1 2 3 4 normal x"})
    void whatIsDamagedIsLeftOut(String text) {
        assertThat(WindowPlace.parse(text)).isEmpty();
    }
}
