package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.Guard;
import majic.bot.LinkLost;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.simulation.SimulatedLab;
import majic.time.TimeSource;
import majicsim.Lab;
import majicsim.LabOptions;
import majicsim.world.Pose;
import majicsim.world.Segment;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the Hemisson's driver with the lab's Hemisson, on the lab's stepped clock. */
class HemissonInLabTest {
    private static final double HULL_MM = 60;
    private static final double ROOM_MM = 10;

    private SimulatedLab simulated;
    private Lab lab;
    private TimeSource time;
    private TimeSource.Membership membership;
    private MajicHemisson bot;

    @AfterEach
    void closeAll() {
        bot.close();
        membership.close();
        simulated.close();
    }

    @ParameterizedTest
    @ValueSource(doubles = {1000, -1000, 100, -100, 20})
    void movesWithinTwoPercent(double mm) throws Exception {
        open(LabOptions.exactOnFreePorts());
        Pose before = pose();

        bot.move(mm);

        Pose after = pose();
        double heading = Math.toRadians(before.headingDeg());
        double ahead =
                (after.xMm() - before.xMm()) * Math.cos(heading) + (after.yMm() - before.yMm()) * Math.sin(heading);
        assertThat(ahead).isCloseTo(mm, within(Math.abs(mm) * 0.02));
        assertThat(bot.get("x").number()).isCloseTo(ahead, within(Math.abs(mm) * 0.02));
    }

    @ParameterizedTest
    @CsvSource({"90,90", "-90,-90", "360,0", "-360,0", "30,30"})
    void turnsWithinTwoPercent(double degrees, double rest) throws Exception {
        open(LabOptions.exactOnFreePorts());
        double before = pose().headingDeg();

        bot.turn(degrees);

        double off = majic.bot.Pose.normalised(pose().headingDeg() - before - rest);
        assertThat(off).isCloseTo(0, within(Math.abs(degrees) * 0.02));
    }

    @ParameterizedTest
    @ValueSource(longs = {0, 1, 2})
    void touchesNothingWhileItsGuardWatchesTheWayAhead(long seed) throws Exception {
        LabOptions exact = LabOptions.exactOnFreePorts();
        open(seed == 0 ? exact : exact.withNoise(seed));
        Guard near = () -> bot.get("distanceFront").number() < bot.get("near").number();
        Random random = new Random(seed);

        for (int approach = 0; approach < 30; approach++) {
            placeNearAWall(random);
            bot.move(400, near);
            assertThat(clearMm()).as("clear at %s", pose()).isPositive();
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1.2, 1.5, 4})
    void isStationaryAfterAnOutageDuringAMotion(double outageSeconds) throws Exception {
        open(LabOptions.exactOnFreePorts());
        after(1, () -> lab.faults("hemisson").outage(outageSeconds));

        assertThatThrownBy(() -> bot.move(1500)).isInstanceOf(BotException.class);
        time.sleep(outageSeconds + 2);

        Pose standing = pose();
        time.sleep(1);
        assertThat(pose()).isEqualTo(standing);
    }

    @Test
    void halvedMessagesHaveNoEffect() throws Exception {
        open(LabOptions.exactOnFreePorts());
        lab.faults("hemisson").halfPackets();
        Pose before = pose();

        bot.move(100);

        assertThat(Math.hypot(pose().xMm() - before.xMm(), pose().yMm() - before.yMm()))
                .isCloseTo(100, within(2.0));
    }

    @Test
    void aCutLineIsReportedAndTheNextConnectionStopsTheRobot() throws Exception {
        open(LabOptions.exactOnFreePorts());
        after(1, () -> lab.faults("hemisson").cut());
        assertThatThrownBy(() -> bot.move(1500)).isInstanceOf(LinkLost.class).hasMessageContaining("lift it");

        bot.connect();

        Pose standing = pose();
        time.sleep(1);
        assertThat(pose()).isEqualTo(standing);
    }

    private void after(double seconds, Runnable fault) {
        time.thread("fault", () -> {
                    try {
                        time.sleep(seconds);
                        fault.run();
                    } catch (InterruptedException e) {
                        Thread.currentThread().interrupt();
                    }
                })
                .start();
    }

    /** Returns a random pose within 200 mm of a wall, in any direction, with room for the hull. */
    private void placeNearAWall(Random random) {
        Segment wall = lab.walls().get(random.nextInt(lab.walls().size()));
        double along = random.nextDouble();
        double x = wall.x1() + along * (wall.x2() - wall.x1()) + 400 * (random.nextDouble() - 0.5);
        double y = wall.y1() + along * (wall.y2() - wall.y1()) + 400 * (random.nextDouble() - 0.5);
        Pose wanted = new Pose(x, y, random.nextDouble() * 360);
        if (clearMm(wanted) > ROOM_MM) {
            lab.place("hemisson", wanted);
        }
    }

    private double clearMm() {
        return clearMm(pose());
    }

    private double clearMm(Pose at) {
        return lab.walls().stream()
                .mapToDouble(wall -> distance(wall, at) - HULL_MM)
                .min()
                .orElseThrow();
    }

    private static double distance(Segment wall, Pose at) {
        double wx = wall.x2() - wall.x1();
        double wy = wall.y2() - wall.y1();
        double share = ((at.xMm() - wall.x1()) * wx + (at.yMm() - wall.y1()) * wy) / (wx * wx + wy * wy);
        double on = Math.max(0, Math.min(1, share));
        return Math.hypot(wall.x1() + on * wx - at.xMm(), wall.y1() + on * wy - at.yMm());
    }

    private Pose pose() {
        return lab.truePoses().get("hemisson");
    }

    private void open(LabOptions options) throws Exception {
        simulated = SimulatedLab.stepped(options);
        lab = simulated.simulators();
        time = simulated.time();
        membership = time.join();
        BotAddress address = simulated.address("hemisson").orElseThrow();
        bot = new MajicHemisson(address, new BotEnvironment(time, Settings.inMemory()));
        bot.connect();
    }
}
