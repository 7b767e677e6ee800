package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

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
        bench.dog().touch("backSensorM", 22);
        assertThat(client.ask("backSensorM.val;")).containsExactly("[notag] 22.000000");

        bench.dog().touch("backSensorM", 0);

        assertThat(client.ask("backSensorM.val;")).containsExactly("[notag] 0.000000");
    }

    @Test
    void onlyTouchSensorsCanBeTouched() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> bench.dog().touch("nose", 1))
                .withMessageContaining("nose");
    }
}
