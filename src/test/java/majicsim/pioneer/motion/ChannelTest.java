package majicsim.pioneer.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ChannelTest {
    private static final Offset<Double> ROUNDING = within(1e-6);

    private final Channel channel = new Channel(new Limits(500, 300, 300));

    @Test
    void aRampIsStraightAndItsWayExact() {
        channel.follow(new Goal.Speed(250));
        run(0.1);
        assertThat(channel.speed()).isCloseTo(30, ROUNDING);
        assertThat(channel.position()).isCloseTo(1.5, ROUNDING);
        run(0.9);
        assertThat(channel.speed()).isEqualTo(250);
        assertThat(channel.position()).isCloseTo(250 * 250 / 600.0 + 250 * (1 - 250 / 300.0), ROUNDING);
    }

    @ParameterizedTest
    @CsvSource({"0.004", "0.0071", "0.1", "3"})
    void theWayDoesNotDependOnTheStep(double stepSeconds) {
        channel.follow(new Goal.Speed(250));
        for (int i = 0; i < Math.round(3 / stepSeconds); i++) {
            step(stepSeconds);
        }
        double seconds = Math.round(3 / stepSeconds) * stepSeconds;
        assertThat(channel.position()).isCloseTo(250 * 250 / 600.0 + 250 * (seconds - 250 / 300.0), ROUNDING);
    }

    @Test
    void turningRoundGoesByWayOfRestWithBothRamps() {
        channel.limits(new Limits(500, 100, 400));
        channel.follow(new Goal.Speed(200));
        run(2);
        channel.follow(new Goal.Speed(-200));
        run(0.5);
        assertThat(channel.speed()).isCloseTo(0, ROUNDING);
        run(1);
        assertThat(channel.speed()).isCloseTo(-100, ROUNDING);
    }

    @ParameterizedTest
    @CsvSource({"1000, 4.2", "-1000, 4.2", "3, 0.5", "5000, 12.5", "-1, 0.3", "90, 1.2"})
    void aWayIsCoveredExactlyAndEndsAtRest(double mm, double seconds) {
        channel.follow(new Goal.Position(mm));
        run(seconds);
        assertThat(channel.position()).isCloseTo(mm, ROUNDING);
        assertThat(channel.speed()).isCloseTo(0, ROUNDING);
    }

    @Test
    void aWayTooShortToBrakeInIsOvershotAndMadeGood() {
        channel.follow(new Goal.Speed(300));
        run(2);
        double target = channel.position() + 50;
        channel.follow(new Goal.Position(target));
        run(1.1);
        assertThat(channel.position()).isGreaterThan(target);
        run(3);
        assertThat(channel.position()).isCloseTo(target, ROUNDING);
        assertThat(channel.speed()).isCloseTo(0, ROUNDING);
    }

    @Test
    void aLowerLimitOnTheWayStillArrives() {
        channel.follow(new Goal.Position(1000));
        run(1);
        channel.limits(channel.limits().withSpeed(100));
        run(1);
        assertThat(channel.speed()).isCloseTo(100, ROUNDING);
        run(9);
        assertThat(channel.position()).isCloseTo(1000, ROUNDING);
    }

    @Test
    void aHeldChannelStopsAndContinuesToItsSetPoint() {
        channel.follow(new Goal.Position(1000));
        run(1);
        channel.hold(true);
        run(2);
        assertThat(channel.speed()).isZero();
        assertThat(channel.position()).isCloseTo(300, ROUNDING);
        channel.hold(false);
        run(5);
        assertThat(channel.position()).isCloseTo(1000, ROUNDING);
    }

    @Test
    void anEmergencyStopEndsWithinOneCycleAndIgnoresCommandsMeanwhile() {
        channel.follow(new Goal.Speed(500));
        run(3);
        channel.emergencyStop();
        channel.follow(new Goal.Speed(500));
        run(0.1);
        assertThat(channel.speed()).isZero();
        run(1);
        assertThat(channel.speed()).isZero();
        channel.follow(new Goal.Speed(100));
        run(1);
        assertThat(channel.speed()).isEqualTo(100);
    }

    private void run(double seconds) {
        for (long left = Math.round(seconds / 0.004); left > 0; left--) {
            step(0.004);
        }
    }

    private void step(double seconds) {
        channel.plan(seconds);
        channel.follow();
    }
}
