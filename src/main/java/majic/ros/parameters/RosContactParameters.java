package majic.ros.parameters;

import java.util.List;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.ros.readings.ActiveHazards;
import majic.ros.readings.RosSensors;

/** Bumpers, cliff sensors, and what else stops a base by itself. */
final class RosContactParameters implements ParameterTheme<RosSensors> {
    private final RosAccess access;

    RosContactParameters(RosAccess access) {
        this.access = access;
    }

    @Override
    public void describe(ParameterTable table, RosSensors sensors) {
        if (sensors.hazards().isEmpty() && sensors.contacts().isEmpty()) {
            return;
        }
        table.add(
                Parameter.yesNo("bumped", "whether a bumper is pressed or the base reports a stall"),
                hazards(hazards -> Value.yesNo(hazards.isBumped())));
        table.add(
                Parameter.text(
                        "hazards", "what bumpers, cliff sensors and the base report: \"bump left\", or \"none\""),
                hazards(hazards -> Value.text(words(hazards.now()))));
    }

    private Supplier<Value> hazards(Function<ActiveHazards, Value> reader) {
        return access.read(readings ->
                readings.hasContacts() ? reader.apply(readings.hazards()) : Value.unknown("no reading of late"));
    }

    private static String words(List<ActiveHazards.Report> hazards) {
        return hazards.isEmpty()
                ? "none"
                : hazards.stream().map(ActiveHazards.Report::words).collect(Collectors.joining(", "));
    }
}
