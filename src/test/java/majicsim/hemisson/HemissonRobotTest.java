package majicsim.hemisson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import majicsim.hemisson.board.CommandBuffer;
import majicsim.hemisson.board.InfraRedSensors;
import majicsim.hemisson.board.RoomSensors;
import majicsim.hemisson.board.SensorTables;
import majicsim.hemisson.modules.ModuleKind;
import majicsim.hemisson.options.HemissonOptions;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Pose;
import majicsim.world.Room;
import majicsim.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

@Timeout(value = 180, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class HemissonRobotTest {
    private static final Pose START = new Pose(-2000, -2000, 0);
    private static final HemissonOptions OVERRUN = HemissonOptions.standard().withOverrun();

    @ParameterizedTest
    @CsvSource({"1,3", "2,18", "5,86", "9,184", "-5,-86"})
    void oneSecondCoversTheDistanceOfTheTable(int value, double mm) throws IOException {
        try (Bench bench = new Bench(HemissonOptions.standard());
                Wire wire = Wire.tcp(bench.tcp.address())) {
            wire.exchange("D," + value + "," + value, "d");
            bench.steps(250);
            assertThat(bench.robot.body().pose().xMm()).isCloseTo(START.xMm() + mm, within(1e-6));
        }
    }

    @Test
    void turnsLeftInPlaceByTheTable() throws IOException {
        try (Bench bench = new Bench(HemissonOptions.standard());
                Wire wire = Wire.tcp(bench.tcp.address())) {
            wire.exchange("D,-4,4", "d");
            bench.steps(250);
            assertThat(bench.robot.body().pose().headingDeg()).isCloseTo(Math.toDegrees(2 * 64 / 90.0), within(1e-6));
            assertThat(bench.robot.body().pose().distanceTo(START)).isCloseTo(0, within(1e-6));
        }
    }

    @Test
    void drivesOnWhenItsClientVanishesAndASecondOneFindsItDriving() throws IOException {
        try (Bench bench = new Bench(HemissonOptions.standard())) {
            try (Wire first = Wire.tcp(bench.tcp.address())) {
                first.exchange("D,5,5", "d");
            }
            bench.awaitNoLine();
            bench.steps(250);
            assertThat(bench.robot.body().pose().xMm()).isCloseTo(START.xMm() + 86, within(1e-6));
            try (Wire second = Wire.tcp(bench.tcp.address())) {
                second.exchange("E", "e,05,05");
            }
        }
    }

    @Test
    void aSecondClientIsTurnedAway() throws IOException {
        try (Bench bench = new Bench(HemissonOptions.standard());
                Wire first = Wire.tcp(bench.tcp.address())) {
            first.exchange("I", "i,1,1,1,1");
            try (Wire second = Wire.tcp(bench.tcp.address())) {
                assertThat(second.in().read()).isEqualTo(-1);
            }
            first.exchange("I", "i,1,1,1,1");
        }
    }

    @Test
    void aBlockedRobotStillReportsItsCommandedSpeed() throws IOException {
        try (Bench bench = new Bench(HemissonOptions.standard());
                Wire wire = Wire.tcp(bench.tcp.address())) {
            bench.robot.body().place(new Pose(4435, 0, 0));
            wire.exchange("D,9,9", "d");
            bench.steps(100);
            assertThat(bench.robot.body().blocked()).isTrue();
            wire.exchange("E", "e,09,09");
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"E\rE\rE\r", "E\rD,1,2\r", "B\rj\rN\rO\r"})
    void withOverrunAThirdWaitingCharacterBlocksTheReceiverAndTheRobotDrivesOn(String burst) throws IOException {
        try (Bench bench = new Bench(OVERRUN);
                Wire wire = Wire.tcp(bench.tcp.address())) {
            wire.send("D,5,5\r");
            bench.awaitConsumed(6);
            bench.steps(1);
            wire.expect("d\r\n");
            wire.send(burst);
            bench.awaitConsumed(6 + burst.length());
            bench.steps(250);
            assertThat(bench.robot.isReceiverBlocked()).isTrue();
            assertThat(bench.robot.body().pose().xMm()).isGreaterThan(START.xMm() + 80);
        }
    }

    @Test
    void withOverrunTwoWaitingCharactersAreStillAnswered() throws IOException {
        try (Bench bench = new Bench(OVERRUN);
                Wire wire = Wire.tcp(bench.tcp.address())) {
            wire.send("N\rO\r");
            bench.awaitConsumed(4);
            bench.steps(3);
            wire.expect("n,004,004,004,004,004,004,060,060\r\no,220,220,220,220,220,220,220,220\r\n");
        }
    }

    @ParameterizedTest
    @CsvSource({"0,250", "10,150", "15,99", "60,5", "90,3", "500,2"})
    void theResponseFollowsTheManualsCurve(double distanceMm, double value) {
        assertThat(RoomSensors.curve(distanceMm)).isCloseTo(value, within(1e-9));
    }

    @Test
    void aWallAheadShowsInFrontAndNowhereElse() throws IOException {
        try (Bench bench = new Bench(HemissonOptions.standard(), null, Noise.exact());
                Wire wire = Wire.tcp(bench.tcp.address())) {
            bench.robot.body().place(new Pose(4500 - 57.5 - 20, 0, 0));
            bench.steps(11);
            wire.exchange("N", "n,048,017,017,002,002,002,165,165");
        }
    }

    @Test
    void aFreeRobotInTheExactLabSeesStillValues() throws IOException {
        try (Bench bench = new Bench(HemissonOptions.standard(), null, Noise.exact());
                Wire wire = Wire.tcp(bench.tcp.address())) {
            wire.exchange("N", "n,002,002,002,002,002,002,165,165");
            wire.exchange("O", "o,220,220,220,220,220,220,220,220");
        }
    }

    @Test
    void aFreeNoisyRobotReadsFromZeroToFourAndNowAndThenLessThanNothing() {
        World world = new World(Room.standard());
        Body body = Body.disc("hemisson", HemissonRobot.RADIUS_MM, START);
        InfraRedSensors sensors = new RoomSensors(world, body, Noise.seeded(5), 220);
        int[] ambient = new int[InfraRedSensors.COUNT];
        int[] response = new int[InfraRedSensors.COUNT];
        Set<Integer> seen = new TreeSet<>();
        for (int i = 0; i < 1000; i++) {
            sensors.look(ambient, response);
            seen.add(response[0]);
        }
        assertThat(seen).containsExactly(-1, 0, 1, 2, 3, 4);
    }

    @Test
    void inBrightLightEverythingLooksFarBecauseProximityNeverExceedsTheAmbientValue() {
        SensorTables tables = new SensorTables(
                (ambient, response) -> {
                    ambient[0] = 20;
                    response[0] = 150;
                },
                new CommandBuffer(true));
        assertThat(tables.proximity(0)).isEqualTo(20);
    }

    @Test
    void groundLeftSubtractsFromTheAmbientValueOfGroundRight() {
        SensorTables tables = new SensorTables(
                (ambient, response) -> {
                    ambient[6] = 220;
                    ambient[7] = 200;
                    response[7] = 60;
                },
                new CommandBuffer(true));
        assertThat(tables.proximity(7)).isEqualTo(80);
    }

    @Test
    void noiseAroundZeroWrapsToLargeValues() {
        SensorTables tables = new SensorTables(
                (ambient, response) -> {
                    ambient[1] = 220;
                    response[1] = -1;
                },
                new CommandBuffer(true));
        assertThat(tables.proximity(1)).isEqualTo(255);
    }

    @Test
    void newValuesComeEvery41Milliseconds() throws IOException {
        int[] looks = {0};
        InfraRedSensors counting = (ambient, response) -> looks[0]++;
        try (Bench bench = new Bench(HemissonOptions.standard(), counting, Noise.exact())) {
            bench.steps(1025);
            assertThat(looks[0]).isEqualTo(1 + 100);
        }
    }

    @Test
    void motorsOfANoisyRobotDifferForGoodAndByAtMostFivePercent() throws IOException {
        try (Bench bench = new Bench(HemissonOptions.standard(), null, Noise.seeded(3));
                Wire wire = Wire.tcp(bench.tcp.address())) {
            wire.exchange("D,5,5", "d");
            bench.steps(1);
            double first = bench.robot.body().turnDegPerSec();
            bench.steps(100);
            assertThat(first).isNotZero();
            assertThat(bench.robot.body().turnDegPerSec()).isCloseTo(first, within(1e-6));
            assertThat(bench.robot.body().speedMmPerSec()).isBetween(86 * 0.95, 86 * 1.05);
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void noBytesUpsetIt(long seed) throws IOException {
        Random random = new Random(seed);
        HemissonOptions modules =
                HemissonOptions.standard().withModules(Set.of(ModuleKind.CAMERA, ModuleKind.ULTRASONIC));
        try (Bench bench = new Bench(modules, null, Noise.seeded(seed));
                Wire wire = Wire.tcp(bench.tcp.address())) {
            int sent = 0;
            for (int i = 0; i < 200; i++) {
                byte[] bytes = new byte[random.nextInt(1, 20)];
                random.nextBytes(bytes);
                bytes[0] = (byte) "BDEHIJLMNOPRTWYZ12!&*".charAt(random.nextInt(21));
                bytes[bytes.length - 1] = '\r';
                wire.out().write(bytes);
                sent += bytes.length;
            }
            bench.awaitConsumed(sent);
            bench.robot.handling().powerCycle();
            bench.steps(2);
            wire.skipTo("HemiOS V1.50");
        }
    }

    @Test
    void theTvRemoteDrivesPastTheSerialLine() throws IOException {
        try (Bench bench = new Bench(HemissonOptions.standard());
                Wire wire = Wire.tcp(bench.tcp.address())) {
            bench.robot.handling().pressTvKey(4);
            wire.exchange("E", "e,-10,10");
            wire.exchange("T", "t,004");
        }
    }

    @Test
    void ledsAndBuzzerFollowTheirCommands() throws IOException {
        try (Bench bench = new Bench(HemissonOptions.standard());
                Wire wire = Wire.tcp(bench.tcp.address())) {
            wire.exchange("L,0,1,0,1", "l");
            wire.exchange("H,1", "h");
            assertThat(bench.robot.handling().leds()).containsExactly(false, true, false, true);
            assertThat(bench.robot.handling().isBuzzing()).isTrue();
        }
    }
}
