package majic.gui.command;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class HistoryTest {
    private final History history = new History();

    @Test
    void withoutLinesTheTypedTextStays() {
        assertThat(history.older("typed")).isEqualTo("typed");
        assertThat(history.newer("typed")).isEqualTo("typed");
    }

    @Test
    void theOldestLineIsTheEnd() {
        history.add("one");
        assertThat(history.older("")).isEqualTo("one");
        assertThat(history.older("one")).isEqualTo("one");
    }

    @Test
    void whatWasBeingTypedComesBack() {
        history.add("one");
        history.older("half a li");
        assertThat(history.newer("one")).isEqualTo("half a li");
    }

    @Test
    void aRepeatedLineIsKeptOnce() {
        history.add("zero");
        history.add("one");
        history.add("one");
        history.older("");
        assertThat(history.older("one")).isEqualTo("zero");
    }
}
