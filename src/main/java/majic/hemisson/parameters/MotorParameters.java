package majic.hemisson.parameters;

import java.util.ArrayList;
import java.util.List;
import majic.bot.Parameter;
import majic.bot.ParameterException;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.hemisson.line.MotorValues;
import majic.hemisson.line.Question;
import majic.hemisson.modules.Modules;
import majic.hemisson.motion.SpeedCalibration;
import majic.hemisson.motion.SpeedTable;
import majic.hemisson.readings.RobotReadings;

/** The values of the motors, and the calibration that gives their speeds. */
final class MotorParameters implements ParameterTheme<Modules> {
    static final String TABLE = "speedTable";

    private final RobotReadings access;
    private final SpeedCalibration calibration;

    MotorParameters(RobotReadings access, SpeedCalibration calibration) {
        this.access = access;
        this.calibration = calibration;
    }

    @Override
    public void describe(ParameterTable table, Modules modules) {
        wheel(table, "speedLeft", "what the left motor is set to, -9 to 9; nothing measures its speed", 0);
        wheel(table, "speedRight", "what the right motor is set to, -9 to 9; nothing measures its speed", 1);
        describeSpeedTable(table);
        table.add(
                        Parameter.number(
                                        "wheelDistance",
                                        Unit.MM,
                                        "from wheel to wheel; calibrate spin measures it; kept for this robot")
                                .within(
                                        SpeedCalibration.WHEEL_DISTANCE_MM.min(),
                                        SpeedCalibration.WHEEL_DISTANCE_MM.max()),
                        () -> Value.of(speeds().wheelDistanceMm(), Unit.MM))
                .kept()
                .writes(values -> calibration.learn(
                        speeds().withWheelDistance(values.get(0).number())));
        table.add(
                        Parameter.number(
                                        "trim",
                                        Unit.PERCENT,
                                        "by how much the right wheel runs faster than the left; kept for this robot")
                                .within(SpeedCalibration.TRIM_PERCENT.min(), SpeedCalibration.TRIM_PERCENT.max()),
                        () -> Value.of(speeds().trimPercent(), Unit.PERCENT))
                .kept()
                .writes(values ->
                        calibration.learn(speeds().withTrim(values.get(0).number())));
    }

    private void wheel(ParameterTable table, String name, String help, int index) {
        table.add(
                Parameter.number(name, Unit.NONE, help),
                access.polledWhileRead(
                        Question.SPEEDS,
                        speeds -> RobotReadings.count(speeds.numbers().get(index))));
    }

    private void describeSpeedTable(ParameterTable table) {
        Parameter list = speed(
                Parameter.list(
                        TABLE,
                        Unit.MM_PER_S,
                        "of a wheel for the motor values 1 to 9, rising; calibrate forward scales it; what set leaves out stays"));
        for (int value = 2; value <= MotorValues.MAX; value++) {
            list = list.with(speed(Parameter.number("speed" + value, Unit.MM_PER_S, "for motor value " + value)));
        }
        table.add(
                        list,
                        () -> Value.many(speeds().speedsMmPerSec().stream()
                                .map(speed -> Value.of(speed, Unit.MM_PER_S))
                                .toList()))
                .kept()
                .writes(this::takeSpeeds);
    }

    private static Parameter speed(Parameter parameter) {
        return parameter.within(SpeedCalibration.WHEEL_MM_PER_SEC.min(), SpeedCalibration.WHEEL_MM_PER_SEC.max());
    }

    private void takeSpeeds(List<Value> values) {
        List<Double> speeds = new ArrayList<>(speeds().speedsMmPerSec());
        for (int index = 0; index < values.size(); index++) {
            speeds.set(index, values.get(index).number());
        }
        if (!SpeedTable.isRising(speeds)) {
            throw new ParameterException(
                    TABLE, TABLE + ": a higher motor value is a higher speed, so nine rising speeds belong here");
        }
        calibration.learn(speeds().withSpeeds(speeds));
    }

    private SpeedTable speeds() {
        return calibration.table();
    }
}
