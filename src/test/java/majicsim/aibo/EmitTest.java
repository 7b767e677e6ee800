package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Events that programs emit (URBI sheet, section 8). */
class EmitTest {
    private final Bench bench = Bench.exact();
    private final Bench.Client client = bench.client();
    private final Bench.Client other = bench.client();

    @Test
    void aHandlerRunsOnceForEachEvent() {
        client.say("at (e) echo \"seen\",");

        assertThat(client.ask("emit e; emit e;")).containsExactly("[notag] *** seen", "[notag] *** seen");
        assertThat(client.ask("")).isEmpty();
    }

    @Test
    void anEventThatWasDeclaredIsNotSeenByItsBareName() {
        client.say("event e; at (e) echo \"bare\", at (e()) echo \"brackets\",");

        assertThat(client.ask("emit e;")).containsExactly("[notag] *** brackets");
        assertThat(client.ask("e;")).isEmpty();
    }

    @Test
    void anEventThatWasDeclaredWithParametersIsSeen() {
        client.say("event e(x); at (e(x)) x,");

        assertThat(client.ask("emit e(4);")).containsExactly("[notag] 4.000000");
    }

    @Test
    void theArgumentsOfAnEventGoToTheNamesInTheTest() {
        client.say("at (e(x,2)) hit: x,");

        assertThat(client.ask("emit e(1,2); emit e(5,6); emit e(7,2); emit e;"))
                .containsExactly("[hit] 1.000000", "[hit] 7.000000");
    }

    @Test
    void anEventOfADottedNameReachesEveryConnection() {
        client.say("at (majic.alarm) echo \"A\",");
        other.say("at (majic.alarm) echo \"B\",");

        other.say("emit majic.alarm;");

        bench.run(100);
        assertThat(client.take()).containsExactly("[notag] *** A");
        assertThat(other.take()).containsExactly("[notag] *** B");
    }

    @Test
    void aBareNameIsAnEventOfItsConnectionAlone() {
        client.say("at (e) echo \"A\",");

        other.say("emit e;");

        assertThat(client.ask("")).isEmpty();
    }

    @Test
    void anEventCanLast() {
        client.say("whenever (e) { now: 1; wait(90) },");

        assertThat(client.ask("emit(300) e;", 700)).hasSizeBetween(3, 4).containsOnly("[now] 1.000000");
    }
}
