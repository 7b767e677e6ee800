package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Joints, lamps and their modifiers (URBI sheet, sections 6, 13 and 14). */
class JointTest {
    private final Bench bench = Bench.exact();
    private final Bench.Client client = bench.client();

    @Test
    void aTargetOutsideTheRangeIsClippedSilently() {
        assertThat(client.ask("motors on; headPan = 500; wait(400); headPan; headPan'n;", 500))
                .containsExactly("[notag] 91.000000", "[notag] 1.000000");
    }

    @Test
    void looseJointsStayWhereTheyAreAndHoldThatWhenSwitchedOn() {
        assertThat(client.ask("m+end: headPan = 45 time:100; wait(100); headPan; headPan.load;", 500))
                .containsExactly("[m] *** end", "[notag] 0.000000", "[notag] 0.000000");
        assertThat(client.ask("motors on; wait(300); headPan; headPan.load;", 500))
                .containsExactly("[notag] 0.000000", "[notag] 1.000000");
    }

    @Test
    void theMeasuredAngleFollowsWithALag() {
        client.say("motors on; headPan = 60 time:1s,");
        bench.run(500);

        String line = client.ask("headPan;", 0).get(0);

        assertThat(Double.parseDouble(line.substring(8))).isBetween(26.0, 29.9);
    }

    @Test
    void aMotorGoesAtMostAsFastAsItCan() {
        client.say("motors on; neck.val = -79; tailPan.val = 59;");
        bench.run(200);

        assertThat(number("neck.val;")).isBetween(-38.0, -34.0);
        assertThat(number("tailPan.val;")).isGreaterThan(58);
    }

    @Test
    void aHalfStiffMotorFollowsSlowerAndLessGainDoesToo() {
        client.say("motors on; neck.load = 0.5; headPan.PGain = 2; neck.val = -79; headPan.val = 80;");
        bench.run(200);

        assertThat(number("neck.val;")).isBetween(-20.0, -16.0);
        assertThat(number("headPan.val;")).isBetween(20.0, 30.0);
        assertThat(number("neck.force;")).isNegative();
    }

    @Test
    void theGainsAreThoseOfTheSheet() {
        assertThat(client.ask("legRF1.PGain; legRF1.IGain; legRF2.PGain; neck.DGain; mouth.PShift; mouth.DShift;"))
                .containsExactly(
                        "[notag] 14.000000",
                        "[notag] 2.000000",
                        "[notag] 10.000000",
                        "[notag] 2.000000",
                        "[notag] 14.000000",
                        "[notag] 15.000000");
    }

    @ParameterizedTest
    @CsvSource({"time:500, 500", "speed:60, 500", "smooth:400, 400", "time:0, 0"})
    void aModifierSetsHowLongItTakes(String modifier, int ms) {
        client.ask("motors on;");
        client.say("m+end: headPan = 30 " + modifier + ";");

        bench.run(ms - 8);
        boolean early = !client.take().isEmpty();
        bench.run(72);

        assertThat(early).isEqualTo(ms == 0);
        assertThat(early || client.take().contains("[m] *** end")).isTrue();
    }

    @Test
    void anOscillationNeverEndsUntilItIsStopped() {
        client.say("motors on; s+end: headPan = 0 sin:1s ampli:20,");
        bench.run(10_256);

        String swinging = client.ask("headPan;", 0).get(0);

        assertThat(Double.parseDouble(swinging.substring(8))).isBetween(17.0, 20.0);
        assertThat(client.ask("stop s;", 500)).isEmpty();
        assertThat(client.ask("headPan;", 500)).isEqualTo(client.ask("headPan;", 500));
    }

    @Test
    void anAssignmentToAGroupGoesToAllItsMembers() {
        assertThat(client.ask("ledF = 0.5; leds.val = 3 time:0; ledF14; ledWIFI; ears = 1; earR;"))
                .containsExactly("[notag] 1.000000", "[notag] 1.000000", "[notag] 1.000000");
    }

    @Test
    void aJointGivenAStringLosesItsMotor() {
        assertThat(client.ask("headPan.val = \"abc\"; headPan;")).containsExactly("[notag] \"abc\"");
    }

    @ParameterizedTest
    @CsvSource({"stand, stand, 3100", "sit, sit, 3100", "beg, sit, 3100", "lay, unknown, 2000", "initial, lay, 4000"})
    void aPostureTakesItsTimeAndIsRecognised(String posture, String guess, int ms) {
        client.ask("motors on; robot.stand();", 3300);
        client.say("p+end: robot." + posture + "();");
        bench.run(ms - 100);
        assertThat(client.take()).isEmpty();
        bench.run(264);
        assertThat(client.take()).containsExactly("[p] *** end");

        assertThat(client.ask("robot.MyguessPosition();")).containsExactly("[notag] \"" + guess + "\"");
    }

    @Test
    void aPostureThatIsThereAlreadyTakesAMoment() {
        client.ask("motors on; robot.stand();", 3300);

        assertThat(client.ask("p+end: robot.StandUp();", 400)).containsExactly("[p] *** end");
        assertThat(client.ask("p+end: robot.SitDown();", 11_500)).isEmpty();
        assertThat(client.ask("", 1000)).containsExactly("[p] *** end");
    }

    @ParameterizedTest
    @ValueSource(strings = {"earL", "ledHC", "ledHW", "modeR", "modeG", "modeB", "ledWIFI"})
    void onOffDevicesAreOnFromOneHalf(String name) {
        assertThat(client.ask("n = 0.3; n; %1$s = 0.5; %1$s; %1$s = 0.4; %1$s;".formatted(name)))
                .containsExactly("[notag] 0.300000", "[notag] 1.000000", "[notag] 0.000000");
    }

    private double number(String question) {
        return Double.parseDouble(client.ask(question, 0).get(0).substring(8));
    }
}
