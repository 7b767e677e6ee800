package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

/** The words to the server itself (URBI sheet, section 9). */
class SystemCommandTest {
    private final Bench bench = Bench.exact();
    private final Bench.Client client = bench.client();
    private final Bench.Client other = bench.client();

    @Test
    void execRunsTextAsAProgram() {
        assertThat(client.ask("x = 2; exec(\"x + 1; echo \\\"a\\\"\"); 4;"))
                .containsExactly("[notag] 3.000000", "[notag] *** a", "[notag] 4.000000");
    }

    @Test
    void whatTheGrammarRefusesInExecCostsOneCommand() {
        assertThat(client.ask("exec(\"1 +; 2\");"))
                .containsExactly("[error] !!! 1.4: syntax error, unexpected ;", "[notag] 2.000000");
    }

    @Test
    void aFileOfTheStickRunsInTheConnectionThatLoadsIt() {
        assertThat(client.ask("save(\"mine.u\", \"mine = 7; mine\"); load(\"mine.u\"); mine;"))
                .containsExactly("[notag] *** \"mine.u\" loaded.", "[notag] 7.000000", "[notag] 7.000000");
        assertThat(client.ask("load(\"nofile.u\");"))
                .containsExactly("[notag] !!! Cannot load the file nofile.u", "[notag] !!! EXPR evaluation failed");
    }

    @Test
    void strictRefusesWhatWasNotDeclaredAndChangesOfType() {
        client.say("strict; var x = 1;");

        assertThat(client.ask("x = 2; x; robot.y = 3; robot.y; x = \"a\"; x;"))
                .containsExactly(
                        "[notag] 2.000000",
                        "[notag] !!! Unknown identifier: robot.y",
                        "[notag] !!! Unknown identifier: robot.y",
                        "[notag] !!! Warning: " + name(client) + ".x type mismatch",
                        "[notag] 2.000000");
        assertThat(client.ask("unstrict; robot.y = 3; robot.y;")).containsExactly("[notag] 3.000000");
    }

    @Test
    void aConnectionCanBeClearedAndClosedFromAnother() {
        String name = name(other);
        other.say("loop h: headPan.val, wait(10s); 1;");
        client.say("killall " + name + ";");
        other.take();
        assertThat(other.ask("2;")).containsExactly("[notag] 2.000000");

        client.say("disconnect " + name + ";");

        assertThat(other.isOpen()).isFalse();
        assertThat(client.ask("disconnect U1; killall nobody;"))
                .containsExactly("[notag] !!! U1: no such connection", "[notag] !!! nobody: no such connection");
    }

    @Test
    void aConnectionReadsItsOwnNameAndClosesItselfByIt() {
        String name = '"' + name(client) + '"';
        client.say("function f() { return local.connectionID };");

        assertThat(client.ask("connectionID; local.connectionID; f();"))
                .containsExactly("[notag] " + name, "[notag] " + name, "[notag] " + name);

        client.say("disconnect local.connectionID;");

        assertThat(client.isOpen()).isFalse();
        assertThat(other.ask("disconnect majic.connectionID;"))
                .containsExactly("[notag] !!! majic.connectionID: no such connection");
    }

    @Test
    void aCommandCanRunInOtherConnections() {
        client.say("x = 1;");
        other.say("x = 2;");

        client.say("t+connection(\"other\")+end: x;");

        bench.run(64);
        assertThat(client.take()).isEmpty();
        assertThat(other.take()).containsExactly("[t] 2.000000", "[t] *** end");
        assertThat(client.ask("+connection(\"nobody\"): x;")).containsExactly("[notag] !!! nobody: no such connection");
    }

    @Test
    void theListingsHaveALineForEachItem() {
        client.say("s = \"abc\"; n = 2.5; group g {headPan,tail}; alias hp headPan.val; poll: every(1s) t: noop,");

        assertThat(client.ask("uservars;"))
                .contains("[notag] *** " + name(client) + ".s = abc", "[notag] *** " + name(client) + ".n = 2.5")
                .doesNotContain("[notag] *** headPan.val = 0");
        assertThat(client.ask("vars;")).contains("[notag] *** headPan.val = 0");
        assertThat(client.ask("group;")).contains("[notag] *** g = {headPan,tail}");
        assertThat(client.ask("alias;"))
                .hasSize(66)
                .contains(
                        "[notag] ***                        hp -> headPan.val",
                        "[notag] ***                   headPan -> headPan.val");
        assertThat(client.ask("def;")).contains("[notag] *** robot.walk : 1 param(s)");
        assertThat(client.ask("commands;")).contains("[notag] *** Tag:[poll]");
    }

    @Test
    void resetStopsAndForgetsAllAndLoadsTheStickAgain() {
        client.say("function robot.own() { 1 }; robot.x = 1; headPan.val->rangemax = 5; lp: loop { wait(100) },");

        List<String> said = client.ask("reset;", 3000);

        assertThat(said)
                .containsExactly(
                        "[notag] *** Reset in progress",
                        "[reset] *** Reset completed.",
                        "[reset] *** Reloading",
                        "[power] *** Battery at 87 %");
        assertThat(client.ask("headPan.val->rangemax; robot.stopwalk(); robot.walkspeed; robot.own(); robot.x;"))
                .containsExactly(
                        "[notag] 91.000000",
                        "[notag] 1000.000000",
                        "[notag] !!! Error with function eval: robot.own [no param]",
                        "[notag] !!! EXPR evaluation failed",
                        "[notag] !!! Unknown identifier: robot.x");
    }

    @Test
    void whatCannotBeForgottenIsRefused() {
        assertThat(client.ask("undef headPan.val; undef nothing.here;"))
                .containsExactly(
                        "[notag] !!! variable headPan.val already in use or is a system var. Cannot delete.",
                        "[notag] !!! identifier nothing.here does not exist");
    }

    @Test
    void resetPutsTheDevicesBack() {
        client.ask(
                "motors on; headPan = 20; ledF1 = 1; camera.format = 0; robot.walkspeed = 500; neck.PGain = 1;", 500);

        client.ask("reset;", 3000);

        assertThat(client.ask("headPan; headPan.load; ledF1; camera.format; robot.walkspeed; neck.PGain;"))
                .containsExactly(
                        "[notag] 20.000000",
                        "[notag] 0.000000",
                        "[notag] 0.000000",
                        "[notag] 1.000000",
                        "[notag] 1000.000000",
                        "[notag] 14.000000");
    }

    @Test
    void noopTakesACycle() {
        assertThat(client.ask("noop; noop; 1;", 32)).isEmpty();

        assertThat(client.ask("", 32)).containsExactly("[notag] 1.000000");
    }

    private String name(Bench.Client of) {
        String answer = of.ask("nothing;").get(0);
        return answer.replaceFirst(".*: (U\\d+)\\..*", "$1");
    }
}
