package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.HashSet;
import java.util.Set;
import majicsim.world.Body;
import majicsim.world.Pose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What the dog measures of the room and of itself (URBI sheet, section 13). */
class SensorTest {
    private final Bench bench = Bench.exact();
    private final Bench.Client client = bench.client();

    @ParameterizedTest
    @CsvSource({
        "1000, 50.000000, 85.000000, 40.000000",
        "500, 35.000000, 35.000000, 40.000000",
        "400, 25.000000, 25.000000, 30.000000",
        "180, 5.700000, 20.000000, 19.000000"
    })
    void distancesAreInCentimetresFromTheNoseWithinTheirRanges(int wallMm, String near, String far, String chest) {
        bench.world().add(Body.box("wall", 10, 10, 500, new Pose(wallMm + 10, 0, 0)));

        assertThat(client.ask("distanceNear.val; distance.val; distanceFar.val; distanceChest.val;"))
                .containsExactly("[notag] " + near, "[notag] " + far, "[notag] " + far, "[notag] " + chest);
    }

    @Test
    void theHeadLooksWhereItIsTurned() {
        bench.world().add(Body.box("to the left", 10, 10, 500, new Pose(90, 410, 90)));
        client.ask("motors on; headPan = 90;", 500);

        assertThat(client.ask("distance.val;")).containsExactly("[notag] 34.000000");
    }

    @Test
    void aDogOnItsFeetFeelsThemAndItsWeight() {
        assertThat(client.ask("pawLF.val; accelZ.val;")).containsExactly("[notag] 0.000000", "[notag] -9.806650");

        client.ask("motors on; robot.stand();", 3300);

        assertThat(client.ask("pawLF.val;")).containsExactly("[notag] 1.000000");
    }

    @Test
    void aTouchIsFeltUntilItEnds() {
        bench.dog().handling().touch("backSensorM", 22);
        assertThat(client.ask("backSensorM.val;")).containsExactly("[notag] 22.000000");

        bench.dog().handling().touch("backSensorM", 0);

        assertThat(client.ask("backSensorM.val;")).containsExactly("[notag] 0.000000");
    }

    @ParameterizedTest
    @CsvSource({"90, side, 0.000000, -9.806650, 0.000000", "180, back, 0.000000, 0.000000, 9.806650"})
    void aDogThatIsTurnedOverReportsIt(double roll, String guess, String x, String y, String z) {
        bench.dog().handling().roll(roll);

        assertThat(client.ask("robot.MyguessPosition(); accelX.val; accelY.val; accelZ.val;"))
                .map(line -> line.replace("-0.000000", "0.000000"))
                .containsExactly("[notag] \"" + guess + "\"", "[notag] " + x, "[notag] " + y, "[notag] " + z);
    }

    @Test
    void sittingItFeelsThatItsFrontIsUp() {
        client.ask("motors on; robot.sit();", 3300);

        assertThat(number("accelX.val;")).isCloseTo(-9.80665 * Math.sin(Math.toRadians(35)), within(0.2));
        assertThat(number("accelZ.val;")).isCloseTo(-9.80665 * Math.cos(Math.toRadians(35)), within(0.2));
    }

    @Test
    void theHeadSeesTheFloorWhenItLooksDown() {
        client.ask("motors on; robot.stand(); headTilt.val = -16; neck.val = -20;", 3700);

        assertThat(number("distance.val;")).isBetween(30.0, 45.0);
    }

    @Test
    void aNoseThatTouchesAWallDoesNotSeeThroughIt() throws IOException {
        Bench room = Bench.in(
                "2D-Map\nLineMinPos: 200 -900\nLineMaxPos: 200 900\nNumLines: 1\nLINES\n200 -900 200 900\nDATA\n");
        Bench.Client guest = room.client();

        assertThat(guest.ask("motors on; neck.val = -79; headTilt.val = 44; wait(700); distanceNear.val;", 1000))
                .containsExactly("[notag] 5.700000");
    }

    @Test
    void aWalkingDogLiftsItsPawsInTurn() {
        client.ask("motors on; robot.stand(); robot.walk(4000),", 3500);
        Set<String> seen = new HashSet<>();
        for (int i = 0; i < 20; i++) {
            seen.addAll(client.ask("string(pawLF.val) + string(pawRF.val);", 100));
        }

        assertThat(seen).contains("[notag] \"10\"", "[notag] \"01\"");
    }

    @Test
    void aPawThatIsPressedIsFelt() {
        bench.dog().handling().touch("pawRH", 1);

        assertThat(client.ask("pawRH.val; pawLH.val;")).containsExactly("[notag] 1.000000", "[notag] 0.000000");
    }

    @Test
    void onlyTouchSensorsCanBeTouched() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> bench.dog().handling().touch("nose", 1))
                .withMessageContaining("nose");
    }

    @Test
    void twoSecondsOnTheChinToggleTheMotors() {
        bench.dog().handling().touch("chinSensor", 1);
        assertThat(client.ask("headPan.load;", 1900)).containsExactly("[notag] 0.000000");
        assertThat(client.ask("", 200)).isEmpty();
        assertThat(client.ask("headPan.load; legRF1.load;")).containsExactly("[notag] 1.000000", "[notag] 1.000000");

        bench.dog().handling().touch("chinSensor", 0);
        client.ask("", 100);
        bench.dog().handling().touch("chinSensor", 1);

        assertThat(client.ask("wait(2200); headPan.load;", 2300)).containsExactly("[notag] 0.000000");
    }

    private double number(String question) {
        return Double.parseDouble(client.ask(question).get(0).substring(8));
    }
}
