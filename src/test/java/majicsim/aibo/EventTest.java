package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Loops, timers and event handlers (URBI sheet, sections 8 and 19). */
class EventTest {
    private final Bench bench = Bench.exact();
    private final Bench.Client client = bench.client();

    @Test
    void aPollSendsEachValueUnderItsTagOnceAPeriod() {
        List<String> lines = client.ask("poll: every(100) { d: distanceNear.val & h: headPan.val },", 500);

        assertThat(lines).hasSize(8).startsWith("[d] 50.000000", "[h] 0.000000", "[d] 50.000000");
        client.say("stop poll;");
        assertThat(client.ask("", 500)).isEmpty();
    }

    @Test
    void theGuardEndsAWalkWhoseControllerFellSilent() {
        client.say("motors on; majic.alive = time();"
                + "guard: every(200) { if (time() - majic.alive > 1500) { stop walk & stop turn } },");
        client.say("w+end: robot.walk(8000),");
        for (int second = 0; second < 3; second++) {
            assertThat(client.ask("majic.alive = time(),", 1000)).isEmpty();
        }

        assertThat(client.ask("", 400)).isEmpty();
        assertThat(client.ask("", 500)).containsExactly("[w] *** end");
        assertThat(bench.dog().body().pose().xMm()).isBetween(83.333 * 3.5, 83.333 * 3.8);
    }

    @Test
    void theGuardOfOneConnectionIsRenewedFromAnother() {
        Bench.Client motion = bench.client();
        motion.say("majic.alive = time(); guard: every(200) { if (time() - majic.alive > 1500) { stop walk } },");
        motion.say("w+end: robot.walk(8000),");
        for (int i = 0; i < 8; i++) {
            client.ask("majic.alive = time(),", 1000);
        }

        assertThat(motion.ask("", 100)).containsExactly("[w] *** end");
    }

    @Test
    void anEventHandlerActsOnTheEdgesOfItsTest() {
        client.say("n = 0; at (n > 0) echo \"n positive\" onleave echo \"n back\",");

        assertThat(client.ask("n = 1;")).containsExactly("[notag] *** n positive");
        assertThat(client.ask("n = 2;")).isEmpty();
        assertThat(client.ask("n = 0;")).containsExactly("[notag] *** n back");
    }

    @Test
    void aSoftTestWaitsUntilItHasHeld() {
        client.say("n = 0; at (n > 0 ~ 500) near: 1,");

        assertThat(client.ask("n = 1;", 300)).isEmpty();
        assertThat(client.ask("", 300)).containsExactly("[near] 1.000000");
    }

    @Test
    void wheneverRepeatsWhileItsTestHolds() {
        client.say("n = 0; w: whenever (n > 0) { 1; wait(100) } else { 2; wait(100) },");
        assertThat(client.ask("", 300)).contains("[notag] 2.000000").doesNotContain("[notag] 1.000000");

        client.ask("n = 1;");

        assertThat(client.ask("", 300)).contains("[notag] 1.000000").doesNotContain("[notag] 2.000000");
    }

    @Test
    void loopsTakeACycleATurn() {
        assertThat(client.ask("loopn (3) 1; for (i = 0; i < 2; i++) i; while (i > 1) { i-- }; i;"))
                .containsExactly(
                        "[notag] 1.000000",
                        "[notag] 1.000000",
                        "[notag] 1.000000",
                        "[notag] 0.000000",
                        "[notag] 1.000000",
                        "[notag] 1.000000");
    }

    @Test
    void anEndlessLoopSendsAboutThirtyOneLinesASecond() {
        assertThat(client.ask("loop h: headPan.val,", 1000)).hasSizeBetween(30, 33);
    }

    @Test
    void timeoutEndsWhatTakesTooLong() {
        assertThat(client.ask("timeout(300) w+end: wait(5s); 1;", 400)).containsExactly("[notag] 1.000000");
    }

    @Test
    void waituntilHoldsItsConnectionUntilTheTestIsTrue() {
        client.say("global.go = 0; waituntil(global.go == 1); 1;");
        assertThat(client.take()).isEmpty();

        bench.client().say("global.go = 1;");

        assertThat(client.ask("", 64)).containsExactly("[notag] 1.000000");
    }

    @Test
    void aGroupYieldsNamesForForeach() {
        assertThat(client.ask("foreach n in group ears { $(n + \".val\") = 1 }; earL; earR;"))
                .containsExactly("[notag] 1.000000", "[notag] 1.000000");
    }
}
