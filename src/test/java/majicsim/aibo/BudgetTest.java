package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

/** What programs may use of the server, and its answer when they exceed that (URBI sheet, sections 2 and 11). */
class BudgetTest {
    private final Bench bench = Bench.exact();
    private final Bench.Client client = bench.client();

    @Test
    void aStringGrowsOnlySoFar() {
        assertThat(client.ask("s = \"0123456789\"; for (i = 0; i < 20; i++) s = s + s;", 1000))
                .contains("[notag] !!! Out of memory", "[notag] !!! EXPR evaluation failed");
        assertThat(client.ask("strlen(s);")).containsExactly("[notag] 163841.000000");
    }

    @Test
    void allVariablesTogetherHoldOnlySoMuch() {
        client.ask("s = \"0123456789\"; for (i = 0; i < 14; i++) s = s + s;", 1000);

        assertThat(client.ask("for (i = 0; i < 300; i++) $(\"v\" + i) = s;", 10_000))
                .contains("[notag] !!! Out of memory");
        assertThat(client.ask("x = 5; x;")).containsExactly("[notag] 5.000000");
    }

    @Test
    void whereTooMuchRunsAnythingShortStillDoes() {
        client.say("l: loop wait(1s),".repeat(5000));
        assertThat(client.take()).containsExactly("[error] !!! CPU Overload");
        Bench.Client other = bench.client();
        assertThat(other.ask("1;" + "wait(10),".repeat(50), 0))
                .containsExactly("[notag] 1.000000", "[error] !!! CPU Overload");

        assertThat(other.ask("stop l;")).isEmpty();

        assertThat(other.ask("t+end: wait(10);", 64)).containsExactly("[t] *** end");
    }

    @Test
    void aFunctionThatReturnsLeavesNothingRunning() {
        client.say("function f() { l: loop { g: 1; wait(50) }, return 2 };");

        assertThat(client.ask("f();")).containsExactly("[g] 1.000000", "[notag] 2.000000");
        assertThat(client.ask("", 500)).isEmpty();
    }

    /** As in the capture of the real splitter, whose two long lines are not kept whole. */
    @Test
    void aCommandLongerThanTheReceiveQueueIsLostAlone() {
        assertThat(client.ask("\"" + "a".repeat(20_000))).isEmpty();
        assertThat(client.ask("a".repeat(20_000)))
                .containsExactly("[error] !!! Receive buffer full", "[error] !!! Receive buffer corrupted");
        assertThat(client.ask("\"; 16;")).containsExactly("[notag] 16.000000");
    }

    @Test
    void aClientThatDoesNotReadLosesWholeMessagesAndGetsAWarning() {
        client.ask("s = \"0123456789\"; for (i = 0; i < 12; i++) s = s + s;", 1000);
        client.say("s;".repeat(100));
        List<String> kept = client.take();

        assertThat(kept).hasSizeBetween(20, 25).allMatch(line -> line.matches("\\[notag] \"(0123456789)*\""));
        assertThat(client.ask("1;")).containsExactly("[error] !!! Send buffer full", "[notag] 1.000000");
    }
}
