package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Tags, flags, stop, freeze and block (URBI sheet, section 7), also across connections. */
class TagTest {
    private final Bench bench = Bench.exact();
    private final Bench.Client client = bench.client();
    private final Bench.Client other = bench.client();

    @Test
    void stopReachesIntoOtherConnections() {
        assertThat(client.ask("lp+end: loop { echo \"A loop\"; wait(150) },", 100))
                .containsExactly("[notag] *** A loop");

        other.say("stop lp;");

        assertThat(client.ask("", 500)).isEmpty();
    }

    @Test
    void aCommandThatIsStoppedByItsOwnTagSendsNoEnd() {
        client.say("w+end: wait(5s),");

        assertThat(client.ask("stop w;", 6000)).isEmpty();
    }

    @Test
    void aCommandThatStopsItselfSendsNoEndAndDoesNotGoOn() {
        assertThat(client.ask("s+end: { 1; stop s; 2 }; 3;")).containsExactly("[notag] 1.000000", "[notag] 3.000000");
    }

    @Test
    void aCommandEndsWhenTheCommandInsideItIsStopped() {
        client.say("outer+end: { inner+end: wait(5s) },");

        assertThat(client.ask("stop inner;")).containsExactly("[outer] *** end");
    }

    @Test
    void stoppingATagStopsItsSecondLevel() {
        client.say("a.b+end: wait(5s), a.c+end: wait(5s),");

        assertThat(client.ask("stop a.b;", 100)).isEmpty();
        assertThat(client.ask("stop a;", 6000)).isEmpty();
    }

    @Test
    void frozenTimeIsNotCounted() {
        client.ask("f+end: wait(500),", 300);
        other.say("freeze f;");
        assertThat(client.ask("", 1000)).isEmpty();

        other.say("unfreeze f;");

        assertThat(client.ask("", 150)).isEmpty();
        assertThat(client.ask("", 100)).containsExactly("[f] *** end");
    }

    @Test
    void whatIsFrozenUnderATimeOutStaysSo() {
        client.ask("n = 0; timeout(10s) f: loop { n++; wait(100) },", 100);
        client.say("freeze f;");
        String frozen = client.ask("n;").get(0);

        assertThat(client.ask("n;", 1000)).containsExactly(frozen);

        client.say("unfreeze f;");
        client.ask("", 1000);
        assertThat(client.ask("n;")).doesNotContain(frozen);
    }

    @Test
    void aConditionFreezesACommandAndReleasesIt() {
        client.ask("h = 1; n = 0; freezeif (h == 1) f: loop { n++; wait(100) },", 500);
        assertThat(client.ask("n;")).containsExactly("[notag] 0.000000");

        client.ask("h = 0;", 500);

        assertThat(client.ask("n;")).doesNotContain("[notag] 0.000000");
    }

    @Test
    void aBlockedTagIsRefusedSilentlyUntilItIsUnblocked() {
        assertThat(client.ask("block b; b+report: 1; 2;")).containsExactly("[notag] 2.000000");
        assertThat(client.ask("unblock b; b: 1;")).containsExactly("[b] 1.000000");
    }

    @Test
    void theTagOfABlockIsNotItsCommands() {
        assertThat(client.ask("u+report: { 1; v: 2 };"))
                .containsExactly("[u] *** begin", "[notag] 1.000000", "[v] 2.000000", "[u] *** end");
    }

    @Test
    void stopOfNoTagKillsWhatHasNone() {
        client.say("loop { x: 1; wait(100) },");
        client.take();

        assertThat(other.ask("stop notag;")).isEmpty();
        assertThat(client.ask("", 500)).isEmpty();
    }

    @Test
    void theBackgroundFlagIsLikeAComma() {
        assertThat(client.ask("t+bg+end: wait(300); 9;", 100)).containsExactly("[notag] 9.000000");
        assertThat(client.ask("", 300)).containsExactly("[t] *** end");
    }

    @Test
    void aFrozenTagHoldsWhatComesWithIt() {
        client.say("freeze f; f+report: 1, f.part: 2,");
        assertThat(client.ask("")).isEmpty();

        other.say("unfreeze f;");

        assertThat(client.ask("")).containsExactly("[f] *** begin", "[f] 1.000000", "[f] *** end", "[f.part] 2.000000");
    }

    @Test
    void aTimeoutAsAFlagEndsTheCommandAndTheConnectionGoesOn() {
        assertThat(client.ask("tm+timeout(200): loop { wait(50) }; 1;", 150))
                .containsExactly("[tm] !!! Warning: +timeout flag is obsolete. Use timeout(time) command instead.");

        assertThat(client.ask("", 150)).containsExactly("[notag] 1.000000");
    }

    @Test
    void aStopAsAFlagIsWarnedOfAndEndsTheCommandWhenItsTestIsTrue() {
        assertThat(client.ask("global.n = 0; t+stop(global.n > 0): loop { wait(50) }; 1;"))
                .containsExactly("[t] !!! Warning: +stop flag is obsolete. Use stopif(test) command instead.");

        other.say("global.n = 1;");

        assertThat(client.ask("")).containsExactly("[notag] 1.000000");
    }

    @Test
    void aFreezeAsAFlagIsWarnedOfAndHoldsTheCommandWhileItsTestIsTrue() {
        assertThat(client.ask("n = 1; t+freeze(n > 0)+end: wait(50),"))
                .containsExactly("[t] !!! Warning: +freeze flag is obsolete. Use freezeif(test) command instead.");

        assertThat(client.ask("n = 0;")).containsExactly("[t] *** end");
    }
}
