package majic.hemisson.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majic.bot.Value;
import majic.hemisson.line.MotorValues;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TimedMotionTest {
    @Test
    void aMetreAtCruiseSpeedTakesTheTimeOfTheSpeedTable() {
        TimedMotion plan = TimedMotion.straight(1000, 42, SpeedTable.USUAL);

        assertThat(plan.wheels()).isEqualTo(new MotorValues(3, 3));
        assertThat(plan.seconds()).isCloseTo(1000 / 42.0, within(1e-9));
    }

    @Test
    void backwardBothWheelsTurnBack() {
        TimedMotion plan = TimedMotion.straight(-100, 42, SpeedTable.USUAL);

        assertThat(plan.wheels()).isEqualTo(new MotorValues(-3, -3));
        assertThat(plan.seconds()).isPositive();
        assertThat(Value.about(plan.way(), plan.unit())).hasToString("about -100 mm");
    }

    @ParameterizedTest
    @CsvSource({"1000,3", "20,3", "10,2", "1,2"})
    void aShortMotionIsSlower(double mm, int value) {
        assertThat(TimedMotion.straight(mm, 42, SpeedTable.USUAL).wheels().right())
                .isEqualTo(value);
    }

    @Test
    void leftIsPositive() {
        TimedMotion plan = TimedMotion.spin(90, 53, SpeedTable.USUAL);

        assertThat(plan.wheels()).isEqualTo(new MotorValues(-3, 3));
        assertThat(plan.seconds() * SpeedTable.USUAL.turnDegPerSec(plan.wheels()))
                .isCloseTo(90, within(1e-9));
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
    void aCurveUsesTheNearestMotorValues(double speed, double turn, int left, int right) {
        assertThat(SpeedTable.USUAL.curve(speed, turn)).isEqualTo(new MotorValues(left, right));
    }

    @ParameterizedTest
    @CsvSource({"5", "-5", "12"})
    void theFasterWheelIsSlowedUntilBothCoverTheSameDistance(double trimPercent) {
        SpeedTable table = SpeedTable.USUAL.withTrim(trimPercent);
        TimedMotion plan = TimedMotion.straight(420, 42, table);

        double drift = table.turnDegPerSec(plan.wheels()) * (1 - plan.easedShare())
                + table.turnDegPerSec(plan.eased()) * plan.easedShare();
        double speed = table.speedMmPerSec(plan.wheels()) * (1 - plan.easedShare())
                + table.speedMmPerSec(plan.eased()) * plan.easedShare();
        assertThat(drift).isCloseTo(0, within(1e-9));
        assertThat(speed).isCloseTo(plan.perSecond(), within(1e-9));
        assertThat(plan.rounds()).isEqualTo((int) Math.round(plan.seconds()));
    }

    @Test
    void withoutTrimNoWheelIsSlowed() {
        assertThat(TimedMotion.straight(420, 42, SpeedTable.USUAL).rounds()).isZero();
    }
}
