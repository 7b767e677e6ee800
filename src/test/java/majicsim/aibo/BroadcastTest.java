package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Commands to a group: what runs in place of them reports its end, not the command itself (URBI sheet, section 21). */
class BroadcastTest {
    private final Bench bench = Bench.exact();
    private final Bench.Client client = bench.client();

    @Test
    void anAssignmentToAGroupEndsForEachMemberAndOnceForTheKernel() {
        assertThat(client.ask("t+end: ledF = 1;")).containsExactlyElementsOf(ends("[t]", 14));
        assertThat(client.ask("+end: ledF.val = 0;")).containsExactlyElementsOf(ends("[notag]", 14));
    }

    @Test
    void theCommandItselfBeginsButDoesNotEnd() {
        client.say("t+begin+end: head = 5 time:200;");

        assertThat(client.take())
                .containsExactly(
                        "[t] *** begin",
                        "[__system__] *** begin",
                        "[t] *** begin",
                        "[t] *** begin",
                        "[t] *** begin",
                        "[t] *** begin");
        assertThat(client.ask("", 300)).containsExactlyElementsOf(ends("[t]", 4));
    }

    @Test
    void aMotorThatIsSwitchedEndsUnderTheKernelsTagAlone() {
        assertThat(client.ask("t+end: headPan off;")).containsExactly("[__system__] *** end");
        assertThat(client.ask("t+end: headPan switch; headPan.load;"))
                .containsExactly("[__system__] *** end", "[notag] 1.000000");
    }

    @Test
    void allMotorsThatAreSwitchedEndNineteenTimesUnderTheKernelsTag() {
        assertThat(client.ask("t+end: motors on;")).containsExactlyElementsOf(ends("[__system__]", 18));
        assertThat(client.ask("t+end: motors off; 1;"))
                .hasSize(20)
                .endsWith("[__system__] *** end", "[notag] 1.000000");
    }

    @Test
    void aChangeIsAnAssignmentOfTheKernels() {
        assertThat(client.ask("i = 1; t+end: i++; i; s = \"a\"; s += \"b\"; s;"))
                .containsExactly("[__system__] *** end", "[notag] 2.000000", "[notag] \"ab\"");
        assertThat(client.ask("ears = 0; t+end: ears += 1; earL; earR;"))
                .containsExactly(
                        "[__system__] *** end",
                        "[__system__] *** end",
                        "[__system__] *** end",
                        "[notag] 1.000000",
                        "[notag] 1.000000");
    }

    @Test
    void inBracesACommandToAGroupEndsOnce() {
        assertThat(client.ask("t+end: { motors off }, u+end: { ledF = 1 & head = 5 },"))
                .containsExactly("[t] *** end", "[u] *** end");
    }

    @Test
    void withoutFlagsNothingIsReported() {
        assertThat(client.ask("motors on; ledF = 1; t: head = 5; legs->blend = mix;"))
                .isEmpty();
    }

    @Test
    void theCommandHoldsItsQueueUntilAllMembersAreThere() {
        assertThat(client.ask("motors on; head = -5 time:1s; 1;", 900)).isEmpty();
        assertThat(client.ask("")).containsExactly("[notag] 1.000000");
    }

    @Test
    void itsTagStopsTheMembersAndNothingElse() {
        client.say("t+end: legs = 10 time:5s,");

        assertThat(client.ask("stop t; 1;")).containsExactly("[notag] 1.000000", "[__system__] *** end");
    }

    /** As many ends under a tag as given, and the kernel's own. */
    private static List<String> ends(String tag, int count) {
        return Stream.concat(Collections.nCopies(count, tag + " *** end").stream(), Stream.of("[__system__] *** end"))
                .toList();
    }
}
