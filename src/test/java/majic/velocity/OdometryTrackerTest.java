package majic.velocity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majic.bot.Pose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Readings of an odometry as continuous states. */
class OdometryTrackerTest {
    private static final BaseDynamics LIMITS = BaseDynamics.of(220, 160, 1);

    private final OdometryTracker tracker = new OdometryTracker(LIMITS, LastOdometry.NONE);
    private double seconds;

    private TrackedState read(double afterS, double xMm, double yMm, double headingDeg) {
        seconds += afterS;
        return tracker.add(new Pose(xMm, yMm, headingDeg), 0, 0, (long) (seconds * 1e9));
    }

    @Test
    void theFirstReadingIsTheStartWhereverTheOdometryBegins() {
        TrackedState first = read(0, 5000, -300, 170);

        assertThat(first.pose().distanceMm(Pose.START)).isLessThan(0.001);
        assertThat(first.pose().headingDeg()).isZero();
        assertThat(first.stationary()).isTrue();
    }

    @Test
    void posesAreRelativeToTheStart() {
        read(0, 1000, 1000, 90);

        TrackedState ahead = read(0.5, 1000, 1100, 90);

        assertThat(ahead.pose().xMm()).isCloseTo(100, within(0.001));
        assertThat(ahead.pose().yMm()).isCloseTo(0, within(0.001));
    }

    @Test
    void fullTurnsAreCounted() {
        read(0, 0, 0, 0);
        TrackedState last = null;
        for (int i = 1; i <= 40; i++) {
            last = read(0.2, 0, 0, i * 20);
        }

        assertThat(last.turnedDeg()).isCloseTo(800, within(0.001));
        assertThat(last.pose().headingDeg()).isCloseTo(80, within(0.001));
    }

    @ParameterizedTest(name = "to {0}, {1}, {2} after {3} s: {4} jumps")
    @CsvSource({
        "400, 0, 0, 0.05, 1",
        "0, 0, 90, 0.05, 1",
        "0, 0, 0, 0.05, 1",
        "110, 0, 3, 0.05, 0",
        "180, 0, 40, 0.01, 0",
        "300, 0, 100, 0.6, 0",
        "102, 1, 0, 0.033, 0"
    })
    void aReadingFartherAwayThanTheBaseCanGoIsAJump(double x, double y, double heading, double afterS, int jumps) {
        read(0, 100, 0, 1);

        TrackedState next = read(afterS, x, y, heading);

        assertThat(next.jumps()).isEqualTo(jumps);
        if (jumps > 0) {
            assertThat(next.pose().distanceMm(Pose.START)).isLessThan(0.001);
            assertThat(next.turnedDeg()).isZero();
            assertThat(next.stationary()).isFalse();
        }
    }

    @Test
    void anOdometryThatBeginsAtZeroDoesNotJumpWhileTheBaseIsThere() {
        read(0, 0, 0, 0);
        read(0.05, 3, 0, 0.5);

        assertThat(read(0.05, 0, 0, 0).jumps()).isZero();
    }

    @Test
    void theVelocitiesFollowFromThePosesIfTheOdometryHasNone() {
        read(0, 0, 0, 10);
        TrackedState last = null;
        for (int i = 1; i <= 10; i++) {
            last = read(0.05, -5 * i * Math.cos(Math.toRadians(10)), -5 * i * Math.sin(Math.toRadians(10)), 10);
        }

        assertThat(last.speedMmPerSec()).isCloseTo(-100, within(1.0));
        assertThat(last.turnRateDegPerSec()).isCloseTo(0, within(0.1));
        assertThat(last.stationary()).isFalse();
    }

    @Test
    void aBaseIsStationaryAFifthOfASecondAfterItsLastMotion() {
        read(0, 0, 0, 0);
        read(0.05, 10, 0, 0);

        assertThat(read(0.05, 10, 0, 0).stationary()).isFalse();
        assertThat(read(0.05, 10, 0, 0).stationary()).isFalse();
        assertThat(read(0.15, 10, 0, 0).stationary()).isTrue();
    }

    @Test
    void noiseOfAMillimetreIsNoMotion() {
        read(0, 0, 0, 0);
        for (int i = 0; i < 20; i++) {
            TrackedState noisy = read(0.033, i % 2, (i + 1) % 2, 0.1 * (i % 3));
            assertThat(i < 8 || noisy.stationary()).isTrue();
        }
    }

    private static TrackedState firstAfterLoss(Pose raw, double lostS) {
        LastOdometry last = new LastOdometry(new Pose(500, 0, 90), new Pose(2000, 0, 180), 1_000_000_000);
        return new OdometryTracker(LIMITS, last).add(raw, 0, 0, (long) ((1 + lostS) * 1e9));
    }

    @Test
    void afterALossThePositionGoesOnFromTheOdometry() {
        TrackedState first = firstAfterLoss(new Pose(1864, 0, 180), 3);

        assertThat(first.pose().xMm()).isCloseTo(500, within(0.001));
        assertThat(first.pose().yMm()).isCloseTo(136, within(0.001));
        assertThat(first.pose().headingDeg()).isCloseTo(90, within(0.001));
        assertThat(first.turnedDeg()).isCloseTo(90, within(0.001));
    }

    @ParameterizedTest(name = "{0}, {1}, {2} after {3} s")
    @CsvSource({"0, 0, 0, 60", "3, -2, 0.5, 60", "9000, 0, 180, 3"})
    void afterALossThePositionStaysWhereTheOdometryBeganAnewOrIsTooFarAway(
            double x, double y, double deg, double lostS) {
        TrackedState first = firstAfterLoss(new Pose(x, y, deg), lostS);

        assertThat(first.pose().xMm()).isCloseTo(500, within(0.001));
        assertThat(first.pose().yMm()).isCloseTo(0, within(0.001));
        assertThat(first.pose().headingDeg()).isCloseTo(90, within(0.001));
    }
}
