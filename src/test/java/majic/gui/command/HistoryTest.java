package majic.gui.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
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

    @Test
    void aLineThatWasTypedBeforeMovesToTheNewestPlace() {
        history.add("one");
        history.add("two");
        history.add("one");
        assertThat(history.older("")).isEqualTo("one");
        assertThat(history.older("one")).isEqualTo("two");
        assertThat(history.older("two")).isEqualTo("two");
    }

    @Test
    void linesOfEarlierSessionsAreOlderThanThoseTypedMeanwhile() {
        history.add("now");
        history.addOlder(List.of("before", "now", "yesterday"));
        assertThat(history.containing("")).containsExactly("now", "yesterday", "before");
    }

    @Test
    void aSearchFindsTheTextAnywhereInAnyCaseNewestFirst() {
        history.add("1 move 500");
        history.add("2 get MOVEs");
        history.add("1 turn 90");
        assertThat(history.containing(" moVe")).containsExactly("2 get MOVEs", "1 move 500");
    }

    @Test
    void onlyTheNewestLinesAreKept() {
        IntStream.rangeClosed(1, History.LONGEST + 5).forEach(number -> history.add("line " + number));
        assertThat(history.containing("")).hasSize(History.LONGEST).endsWith("line 6");
    }
}
