package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Forms of the language that few programs use and the 1.0 kernel takes (URBI sheet, section 21). */
class OldFormsTest {
    private final Bench bench = Bench.exact();
    private final Bench.Client client = bench.client();

    @Test
    void anIndexReachesIntoAList() {
        assertThat(client.ask("l = [1,2,\"three\"]; l[0]; l[2]; i = 1; l[i] + 1;"))
                .containsExactly("[notag] 1.000000", "[notag] \"three\"", "[notag] 3.000000");
        assertThat(client.ask("l[3]; l[-1]; l[0] = 7; l[0]; head(l);"))
                .containsExactly(
                        "[notag] !!! Index out of range",
                        "[notag] !!! Index out of range",
                        "[notag] 7.000000",
                        "[notag] 1.000000");
    }

    @Test
    void defDeclaresAVariableAndDefinesAFunction() {
        assertThat(client.ask("def z; isdef(z); z; def k(x) { return x + 1 }; k(4); def g.f() { 5 }; g.f();"))
                .containsExactly("[notag] 1.000000", "[notag] 5.000000", "[notag] 5.000000");
        assertThat(client.ask("def;")).contains("[notag] *** g.f : 0 param(s)");
    }

    @Test
    void aCopyIsTheValue() {
        assertThat(client.ask("a = [1,2]; b = copy a; b; copy 3; copy a + 3;"))
                .containsExactly(
                        "[notag] [1.000000,2.000000]", "[notag] 3.000000", "[notag] [1.000000,2.000000,3.000000]");
    }

    @Test
    void aStaticVariableIsReadOnceByACommand() {
        assertThat(client.ask("static c = 10; static c; static c + 1;"))
                .containsExactly("[notag] 10.000000", "[notag] 11.000000");

        client.ask("x = 0; x = c sin:100ms ampli:0, y = 0; y = static c sin:100ms ampli:0,");
        client.ask("c = 20;");

        assertThat(client.ask("x; y;")).containsExactly("[notag] 20.000000", "[notag] 10.000000");
    }

    @Test
    void theBallIsAnObject() {
        List<String> answers = client.ask("ball.a; ball.x; ball.y; ball.visible; ball;");

        assertThat(answers)
                .startsWith("[notag] 0.950000", "[notag] -1.000000", "[notag] -1.000000", "[notag] 0.000000")
                .hasSize(5);
        assertThat(answers.get(4))
                .startsWith("[notag] OBJ [")
                .contains("a:0.950000", "x:-1.000000", "visible:0.000000");
    }

    @Test
    void theStickHasSixtyFiveAliasesAndAFileForScriptsOfOnesOwn() {
        assertThat(client.ask("alias;")).hasSize(65).contains("[notag] ***                    camera -> camera.val");
        assertThat(client.ask("load(\"custom.u\");")).containsExactly("[notag] *** \"custom.u\" loaded.");
    }

    @Test
    void aBareNameStandsForTheFieldValOfTheStickDevicesOnly() {
        assertThat(client.ask("foo.val = 3; distanceFar; distanceFar.val->rangemax; foo;"))
                .startsWith("[notag] 150.000000", "[notag] 150.000000")
                .last()
                .asString()
                .contains("Unknown identifier");
    }

    @Test
    void theSensorsAreGrouped() {
        assertThat(client.ask(
                        "group buttonsensors; group touchsensors; group irsensors; group accelsensors; group ledHead;"))
                .containsExactly(
                        "[notag] [\"pawLF\",\"pawLH\",\"pawRF\",\"pawRH\",\"chinSensor\",\"WIFIswitch\"]",
                        "[notag] [\"headSensor\",\"backSensorR\",\"backSensorM\",\"backSensorF\"]",
                        "[notag] [\"distanceNear\",\"distance\",\"distanceChest\"]",
                        "[notag] [\"accelZ\",\"accelY\",\"accelX\"]",
                        "[notag] [\"modeR\",\"modeG\",\"modeB\",\"ledHC\",\"ledHW\"]");
    }

    @Test
    void theListOfVariablesHasTheNamesOfTheStick() {
        assertThat(client.ask("vars;"))
                .contains(
                        "[notag] *** walk.mean__1__1 = -17.4",
                        "[notag] *** turn.coef__2 = 0.5",
                        "[notag] *** robot.walkspeed = 1000",
                        "[notag] *** ball.a = 0.95")
                .noneMatch(line -> line.contains("distanceFar"));
    }
}
