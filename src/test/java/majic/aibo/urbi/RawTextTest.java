package majic.aibo.urbi;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RawTextTest {
    @Test
    void losesTheSeparatorAtItsEnd() {
        assertThat(RawText.checked(" headPan.val; ")).isEqualTo("headPan.val");
        assertThat(RawText.checked("echo \"a } \\\" ;\";")).isEqualTo("echo \"a } \\\" ;\"");
    }

    @Test
    void aLongTextIsNoTrouble() {
        String text = "echo \"" + "\\n\\\"".repeat(7_000) + "\"";

        assertThat(RawText.checked(text)).isEqualTo(text);
    }

    @ParameterizedTest
    @ValueSource(strings = {"a = [1", "f(1))", "echo \"open", "1 # no", "1 // no", "$$", "{ ) }"})
    void whatWouldSwallowTheNextCommandIsRefused(String text) {
        assertThatThrownBy(() -> RawText.checked(text)).isInstanceOf(UrbiRefusal.class);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "quit",
                "1; disconnect U123",
                "killall U1",
                "legs.val->blend = cancel",
                "speaker.val = BIN 4 raw 1 8000 8 1"
            })
    void whatClosesConnectionsOrSpoilsTheGaitIsRefused(String text) {
        assertThatThrownBy(() -> RawText.checked(text)).hasMessageContaining("is not sent");
    }
}
