package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

/** What may stand behind an assignment (URBI sheet, section 6); plain variables, so that no motor plays a part. */
class ModifierTest {
    private final Bench bench = Bench.exact();
    private final Bench.Client client = bench.client();

    @Test
    void anOscillationReportsItsPhase() {
        client.say("x = 0; s: x = 0 sin:1s ampli:1 getphase:ph,");

        double phase = value(client.ask("ph;", 0));
        double later = value(client.ask("", 250).isEmpty() ? client.ask("ph;", 0) : List.of());

        assertThat(phase).isBetween(0.0, 0.3);
        assertThat(later - phase).isBetween(1.3, 1.8);
    }

    @Test
    void thePhaseNeedsAVariableToGoTo() {
        assertThat(client.ask("x = 0; x = 0 sin:1s getphase:3,"))
                .containsExactly("[notag] !!! a variable is expected for the 'getphase' modificator");
    }

    @Test
    void aTimeLimitEndsAnAssignmentWhereItIs() {
        assertThat(client.ask("x = 0; t+end: x = 10 time:1s timelimit:500;", 600))
                .containsExactly("[t] *** end");

        assertThat(value(client.ask("x;"))).isBetween(4.0, 5.5);
    }

    @Test
    void anAdaptiveAssignmentEndsAtItsTarget() {
        assertThat(client.ask("x = 0; t+end: x = 10 speed:20 adaptive:1;", 400)).isEmpty();

        assertThat(client.ask("", 300)).containsExactly("[t] *** end");
        assertThat(client.ask("x;")).containsExactly("[notag] 10.000000");
    }

    @Test
    void anAccelerationAloneTakesTheTimeItNeeds() {
        assertThat(client.ask("x = 0; t+end: x = 10 accel:20;", 900)).isEmpty();

        assertThat(client.ask("", 200)).containsExactly("[t] *** end");
    }

    @Test
    void speedminHastensAnAssignment() {
        client.say("x = 0; x->speedmin = 20;");

        assertThat(client.ask("t+end: x = 10 time:5s;", 600)).containsExactly("[t] *** end");
    }

    @Test
    void whatIsNotThereHasNoValueToStartFrom() {
        String error = client.ask("nosuch = 5 time:100;").get(0);

        assertThat(error).matches("\\[notag] !!! Modificator error: U\\d+\\.nosuch unknown \\(no start value\\)");
        assertThat(client.ask("nosuch = 5 sin:1s ampli:0, nosuch;")).containsExactly("[notag] 5.000000");
    }

    @Test
    void aStringTakesValuesByTheirNames() {
        assertThat(client.ask("s = \"I am $who, $age\" who:\"Aibo\" age:3; s;"))
                .containsExactly("[notag] \"I am Aibo, 3\"");
    }

    @Test
    void aSwingFollowsTheVariablesInIt() {
        client.ask("x = 0; a = 1; c = 10; x = c sin:100ms ampli:a phase:pi/2 - 2*pi*time()/100,");
        assertThat(value(client.ask("x;"))).isBetween(9.0, 11.0);

        client.ask("c = 20; a = 0;");

        assertThat(value(client.ask("x;"))).isEqualTo(20);
    }

    @Test
    void aSpeedThatChangesUnderWayCounts() {
        client.say("x = 0; s = 1; t+end: x = 10 speed:s,");
        assertThat(client.ask("", 1000)).isEmpty();

        assertThat(client.ask("s = 100;", 64)).containsExactly("[t] *** end");
        assertThat(client.ask("x;")).containsExactly("[notag] 10.000000");
    }

    @Test
    void theFlagErrorReportsEnforcedLimits() {
        client.say("x = 0; x->speedmin = 20; y = 0; y->speedmax = 20;");

        assertThat(client.ask("t+error: x = 10 time:5s; u+error: y = 10 time:100; x = 0 time:5s;", 2000))
                .containsExactly(
                        "[t] !!! low speed: increased to speedmin",
                        "[u] !!! Warning: request exceeds speedmax. Enforcing limitation");
    }

    private static double value(List<String> lines) {
        return Double.parseDouble(lines.get(0).replaceFirst("\\[notag] ", ""));
    }
}
