package majic.hemisson.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majic.hemisson.line.MotorValues;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TimedMotionTest {
    @Test
    void aMetreAtCruiseTakesWhatTheTableSays() {
        TimedMotion leg = TimedMotion.straight(1000, 42, SpeedTable.USUAL);

        assertThat(leg.wheels()).isEqualTo(new MotorValues(3, 3));
        assertThat(leg.seconds()).isCloseTo(1000 / 42.0, within(1e-9));
    }

    @Test
    void backwardBothWheelsTurnBack() {
        TimedMotion leg = TimedMotion.straight(-100, 42, SpeedTable.USUAL);

        assertThat(leg.wheels()).isEqualTo(new MotorValues(-3, -3));
        assertThat(leg.seconds()).isPositive();
        assertThat(leg.covered(leg.seconds())).hasToString("about -100 mm");
    }

    @ParameterizedTest
    @CsvSource({"1000,3", "20,3", "10,2", "1,2"})
    void aShortWayIsGoneSlower(double mm, int value) {
        assertThat(TimedMotion.straight(mm, 42, SpeedTable.USUAL).wheels().right())
                .isEqualTo(value);
    }

    @Test
    void leftIsPositive() {
        TimedMotion leg = TimedMotion.spin(90, 53, SpeedTable.USUAL);

        assertThat(leg.wheels()).isEqualTo(new MotorValues(-3, 3));
        assertThat(leg.seconds() * SpeedTable.USUAL.turnDegPerSec(leg.wheels())).isCloseTo(90, within(1e-9));
    }

    @Test
    void widerWheelsTurnLonger() {
        double usual = TimedMotion.spin(360, 53, SpeedTable.USUAL).seconds();

        assertThat(TimedMotion.spin(360, 47, SpeedTable.USUAL.withWheelDistance(100))
                        .seconds())
                .isCloseTo(usual * 100 / 90, within(1e-9));
    }

    @Test
    void aSlowRobotMovesLonger() {
        assertThat(TimedMotion.straight(100, 21, SpeedTable.USUAL.scaled(0.5)).seconds())
                .isCloseTo(100 / 21.0, within(1e-9));
    }

    @ParameterizedTest
    @CsvSource({"42,0,3,3", "0,53,-3,3", "0,-53,3,-3", "-64,0,-4,-4", "86,29,4,6", "184,234,0,9", "5,0,0,0"})
    void aCurveGetsTheNearestWheelValues(double speed, double turn, int left, int right) {
        assertThat(SpeedTable.USUAL.curve(speed, turn)).isEqualTo(new MotorValues(left, right));
    }

    @ParameterizedTest
    @CsvSource({"5", "-5", "12"})
    void theFasterWheelIsEasedUntilBothGoEquallyFar(double trimPercent) {
        SpeedTable table = SpeedTable.USUAL.withTrim(trimPercent);
        TimedMotion leg = TimedMotion.straight(420, 42, table);

        double drift = table.turnDegPerSec(leg.wheels()) * (1 - leg.easedShare())
                + table.turnDegPerSec(leg.eased()) * leg.easedShare();
        double speed = table.speedMmPerSec(leg.wheels()) * (1 - leg.easedShare())
                + table.speedMmPerSec(leg.eased()) * leg.easedShare();
        assertThat(drift).isCloseTo(0, within(1e-9));
        assertThat(speed).isCloseTo(leg.perSecond(), within(1e-9));
        assertThat(leg.rounds()).isEqualTo((int) Math.round(leg.seconds()));
    }

    @Test
    void withoutTrimNoWheelIsEased() {
        assertThat(TimedMotion.straight(420, 42, SpeedTable.USUAL).rounds()).isZero();
    }
}
