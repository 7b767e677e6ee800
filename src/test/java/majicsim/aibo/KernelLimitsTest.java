package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What the 1.0 kernel refuses, so that a script that passes here passes on the dog (URBI sheet, section 21). */
class KernelLimitsTest {
    private static final String NO_CALL = "[notag] !!! Custom function call in expressions not allowed in kernel 1";
    private static final String FAILED = "[notag] !!! EXPR evaluation failed";

    private final Bench bench = Bench.exact();
    private final Bench.Client client = bench.client();

    @Test
    void aFunctionCannotCallItselfInAnExpression() {
        client.say("function fact(n) { if (n < 2) return 1 else return n * fact(n - 1) };");

        assertThat(client.ask("fact(1); fact(5);")).containsExactly("[notag] 1.000000", NO_CALL, FAILED);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "1 + g(2);",
                "abs(g(2));",
                "if (g(2)) 1;",
                "echo g(2);",
                "x = 1 - g(2);",
                "g(g(2));",
                "wait(g(2));"
            })
    void aFunctionIsCalledByACommandOfItsOwnOnly(String command) {
        client.say("function g(n) { return n };");

        assertThat(client.ask(command)).startsWith(NO_CALL);
    }

    @Test
    void aFunctionGivesItsValueToAReplyAndToAnAssignment() {
        client.say("function g(n) { return n };");

        assertThat(client.ask("t: g(2); (g(3)); x = g(4); x; headPan = g(0) time:50; isdef(g);"))
                .containsExactly("[t] 2.000000", "[notag] 3.000000", "[notag] 4.000000", "[notag] 1.000000");
    }

    @Test
    void theStickGuessesThePostureInACommandOfItsOwnOnly() {
        assertThat(client.ask("robot.MyguessPosition(); if (robot.MyguessPosition() == \"lay\") 1;"))
                .containsExactly("[notag] \"lay\"", NO_CALL, FAILED);
    }

    @Test
    void aLoopOverAListNeedsBraces() {
        assertThat(client.ask("foreach e in [1,2] echo e;"))
                .containsExactly("[error] !!! 19.20-23: syntax error, unexpected echo");
        assertThat(client.ask("foreach e in [1,2] { echo e };"))
                .containsExactly("[notag] *** 1.000000", "[notag] *** 2.000000");
    }

    @Test
    void theVariablesOfAFunctionAreItsOwn() {
        String unknown =
                client.ask("function f() { x = 5; y[1] = 6; x; y[1] }; f(); x;").get(2);

        assertThat(unknown).matches("\\[notag] !!! Unknown identifier: U\\d+\\.x");
        assertThat(client.ask("uservars;")).noneMatch(line -> line.contains(".x = ") || line.contains("__UFnct"));
    }

    @Test
    void aFunctionSeesWhatItsConnectionHasAndTheDevices() {
        client.say("x = 1; function f() { x = x + 1; headPan = 3 };");

        assertThat(client.ask("motors on; f(); x; wait(100); headPan;"))
                .containsExactly("[notag] 2.000000", "[notag] 3.000000");
    }

    @Test
    void whatAFunctionDoesNotFindIsNamedAsItsOwn() {
        assertThat(client.ask("function f() { nothing }; f();").get(0))
                .matches("\\[notag] !!! Unknown identifier: __UFnct\\d+\\.nothing");
    }

    @Test
    void aVariableThatIsMissingHasNoProperties() {
        String name = client.ask("nothing->blend = mix;").get(0);

        assertThat(name).matches("\\[notag] !!! Variable U\\d+\\.nothing does not exist");
        assertThat(client.ask("dev.val->rangemin = 3; dev.val->blend; isdef(dev.val);"))
                .containsExactly(
                        "[notag] !!! Variable dev.val does not exist",
                        "[notag] !!! Unknown identifier: dev.val",
                        FAILED,
                        "[notag] 0.000000");
    }
}
