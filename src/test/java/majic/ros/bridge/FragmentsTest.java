package majic.ros.bridge;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import org.junit.jupiter.api.Test;

/** Joining of fragments. */
class FragmentsTest {
    private static final int MOST = 100;

    private final Fragments fragments = new Fragments(MOST);

    private static ObjectNode part(String id, String data, int number, double total) {
        ObjectNode part = JsonNodeFactory.instance.objectNode();
        return part.put("id", id).put("data", data).put("num", number).put("total", total);
    }

    @Test
    void partsAreJoinedInTheirOrderHoweverTheyArriveAndTheTotalIsRoundedDown() {
        assertThat(fragments.add(part("a", "world", 2, 3.07))).isNull();
        assertThat(fragments.add(part("b", "one", 0, 1.9))).isEqualTo("one");
        assertThat(fragments.add(part("a", "hello", 0, 3.07))).isNull();
        assertThat(fragments.add(part("a", " ", 1, 3.07))).isEqualTo("hello world");
    }

    @Test
    void theSameIdCanBeUsedAgain() {
        fragments.add(part("0", "a", 0, 2));
        assertThat(fragments.add(part("0", "b", 1, 2))).isEqualTo("ab");
        fragments.add(part("0", "c", 0, 2));
        assertThat(fragments.add(part("0", "d", 1, 2))).isEqualTo("cd");
    }

    @Test
    void theOldestIncompleteMessageIsGivenUpWhenThereIsTooMuch() {
        fragments.add(part("old", "x".repeat(60), 0, 2));
        fragments.add(part("new", "y".repeat(60), 0, 2));

        assertThat(fragments.add(part("old", "x", 1, 2))).isNull();
        assertThat(fragments.add(part("new", "y", 1, 2))).hasSize(61);
    }

    @Test
    void aMessageThatIsTooLongAltogetherIsNotKept() {
        for (int i = 0; i < 50; i++) {
            assertThat(fragments.add(part("long", "x".repeat(60), i, 50))).isNull();
        }
        assertThat(fragments.add(part("next", "ok", 0, 1))).isEqualTo("ok");
    }

    @Test
    void impossibleFragmentsAreIgnored() {
        assertThat(fragments.add(part("a", "x", 1, 1))).isNull();
        assertThat(fragments.add(part("a", "x", -1, 1))).isNull();
        assertThat(fragments.add(part("a", "x", 0, 0.5))).isNull();
        assertThat(fragments.add(part("a", "x", 0, 1e18))).isNull();
        assertThat(fragments.add(part("a", "x", 0, Double.NaN))).isNull();
        assertThat(fragments.add(JsonNodeFactory.instance.objectNode())).isNull();
    }
}
