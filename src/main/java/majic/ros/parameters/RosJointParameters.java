package majic.ros.parameters;

import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
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
 * Wheels and other joints; subscribed to while something reads them. Which joints slide is not in the messages, but in
 * the description of the robot; without one all of them are taken to turn.
 */
final class RosJointParameters implements ParameterTheme<RosSensors> {
    private static final Value NOT_REPORTED = Value.unknown("not reported");
    private static final double MM_PER_M = 1000;

    private final RosAccess access;

    RosJointParameters(RosAccess access) {
        this.access = access;
    }

    @Override
    public void describe(ParameterTable table, RosSensors sensors) {
        if (sensors.joints().isEmpty()) {
            return;
        }
        Set<String> sliding = sensors.slidingJoints();
        table.add(
                list("joints", sliding, Unit.DEG, "angles of the joints, ways of those that slide"),
                read(joints -> values(joints, joint -> position(joint, sliding))));
        table.add(
                list("jointRates", sliding, Unit.DEG_PER_S, "how fast the joints move"),
                read(joints -> values(joints, joint -> velocity(joint, sliding))));
        table.add(
                Parameter.text("jointNames", "the names of the joints"),
                read(joints ->
                        Value.text(joints.stream().map(JointReading::name).collect(Collectors.joining(", ")))));
    }

    /** A list of values with different units has no unit itself. */
    private static Parameter list(String name, Set<String> sliding, Unit turning, String help) {
        return Parameter.list(name, sliding.isEmpty() ? turning : Unit.NONE, help + ", in the order of jointNames");
    }

    private Supplier<Value> read(Function<List<JointReading>, Value> reader) {
        return access.requested(RosReadings::joints, (JointsMessage message) -> reader.apply(message.joints()));
    }

    private static Value values(List<JointReading> joints, Function<JointReading, Value> reader) {
        return Value.many(joints.stream().map(reader).toList());
    }

    private static Value position(JointReading joint, Set<String> sliding) {
        return sliding.contains(joint.name())
                ? millimetres(joint.position(), Unit.MM)
                : degrees(joint.position(), Unit.DEG);
    }

    private static Value velocity(JointReading joint, Set<String> sliding) {
        return sliding.contains(joint.name())
                ? millimetres(joint.velocity(), Unit.MM_PER_S)
                : degrees(joint.velocity(), Unit.DEG_PER_S);
    }

    private static Value millimetres(OptionalDouble metres, Unit unit) {
        return metres.isEmpty() ? NOT_REPORTED : Value.of(metres.getAsDouble() * MM_PER_M, unit);
    }

    private static Value degrees(OptionalDouble radians, Unit unit) {
        return radians.isEmpty() ? NOT_REPORTED : Value.of(Math.toDegrees(radians.getAsDouble()), unit);
    }
}
