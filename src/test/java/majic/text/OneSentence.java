package majic.text;

import static org.assertj.core.api.Assertions.assertThat;

import org.jspecify.annotations.Nullable;

/** The form of a message that refuses input. */
public final class OneSentence {
    private OneSentence() {}

    /** Fails unless a message is one line of visible characters. */
    public static void check(@Nullable String message) {
        assertThat(message).isNotBlank().isEqualTo(VisibleText.of(String.valueOf(message)));
    }
}
