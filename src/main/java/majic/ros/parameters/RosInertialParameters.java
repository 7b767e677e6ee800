package majic.ros.parameters;

import java.util.Optional;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.ros.message.ImuMessage;
import majic.ros.message.Orientation;
import majic.ros.message.Vector;
import majic.ros.readings.RosReadings;
import majic.ros.readings.RosSensors;

/** The inertial unit; subscribed to while something reads it. */
final class RosInertialParameters implements ParameterTheme<RosSensors> {
    private static final Value NOT_MEASURED = Value.unknown("the inertial unit does not measure it");

    private final RosAccess access;

    RosInertialParameters(RosAccess access) {
        this.access = access;
    }

    @Override
    public void describe(ParameterTable table, RosSensors sensors) {
        if (sensors.imu().isEmpty()) {
            return;
        }
        angle(table, "roll", "tilt to the side, right side down positive; requested when read", Orientation::rollDeg);
        angle(table, "pitch", "tilt forward, front down positive; requested when read", Orientation::pitchDeg);
        angle(
                table,
                "compass",
                "heading of the inertial unit, left positive, from its own zero; requested when read",
                Orientation::yawDeg);
        number(
                table,
                Parameter.number("gyro", Unit.DEG_PER_S, "turn rate, left positive; requested when read"),
                ImuMessage::ratesDegPerSec,
                Vector::z);
        acceleration(table, "accelX", "acceleration ahead, m/s²; requested when read", Vector::x);
        acceleration(table, "accelY", "acceleration to the left, m/s²; requested when read", Vector::y);
        acceleration(table, "accelZ", "acceleration upwards, m/s²; about 9.8 at rest; requested when read", Vector::z);
    }

    private void angle(ParameterTable table, String name, String help, ToDoubleFunction<Orientation> angle) {
        number(table, Parameter.number(name, Unit.DEG, help), ImuMessage::orientation, angle);
    }

    private void acceleration(ParameterTable table, String name, String help, ToDoubleFunction<Vector> axis) {
        number(table, Parameter.number(name, Unit.NONE, help), ImuMessage::accelerations, axis);
    }

    private <T> void number(
            ParameterTable table,
            Parameter parameter,
            Function<ImuMessage, Optional<T>> part,
            ToDoubleFunction<T> number) {
        table.add(
                parameter,
                access.requested(
                        RosReadings::imu,
                        imu -> part.apply(imu)
                                .map(found -> Value.of(number.applyAsDouble(found), parameter.unit()))
                                .orElse(NOT_MEASURED)));
    }
}
