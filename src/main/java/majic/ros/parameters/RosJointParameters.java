package majic.ros.parameters;

import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.ros.message.JointsMessage;
import majic.ros.message.JointsMessage.JointReading;
import majic.ros.readings.RosReadings;
import majic.ros.readings.RosSensors;

/**
 * Wheels and other joints; subscribed to while something reads them. Messages do not say which joints slide, so all numbers
 * are given as those of joints that turn; the metres of one that slides are in {@code topic/joint_states/position}.
 */
final class RosJointParameters implements ParameterTheme<RosSensors> {
    private static final Value NOT_REPORTED = Value.unknown("not reported");

    private final RosAccess access;

    RosJointParameters(RosAccess access) {
        this.access = access;
    }

    @Override
    public void describe(ParameterTable table, RosSensors sensors) {
        if (sensors.joints().isEmpty()) {
            return;
        }
        table.add(
                Parameter.list("joints", Unit.DEG, "angles of the joints that turn, in the order of jointNames"),
                read(joints -> values(joints, JointReading::position, Unit.DEG)));
        table.add(
                Parameter.list("jointRates", Unit.DEG_PER_S, "how fast the joints turn, in the order of jointNames"),
                read(joints -> values(joints, JointReading::velocity, Unit.DEG_PER_S)));
        table.add(
                Parameter.text("jointNames", "the names of the joints"),
                read(joints ->
                        Value.text(joints.stream().map(JointReading::name).collect(Collectors.joining(", ")))));
    }

    private Supplier<Value> read(Function<List<JointReading>, Value> reader) {
        return access.requested(RosReadings::joints, (JointsMessage message) -> reader.apply(message.joints()));
    }

    private static Value values(List<JointReading> joints, Function<JointReading, OptionalDouble> part, Unit unit) {
        return Value.many(
                joints.stream().map(joint -> value(part.apply(joint), unit)).toList());
    }

    private static Value value(OptionalDouble radians, Unit unit) {
        return radians.isEmpty() ? NOT_REPORTED : Value.of(Math.toDegrees(radians.getAsDouble()), unit);
    }
}
