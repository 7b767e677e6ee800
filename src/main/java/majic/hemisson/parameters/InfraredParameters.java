package majic.hemisson.parameters;

import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Function;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.hemisson.line.Question;
import majic.hemisson.modules.Modules;
import majic.hemisson.readings.Clearance;
import majic.hemisson.readings.Proximity;
import majic.hemisson.readings.RobotReadings;

/** The eight infra-red sensors: distance, proximity and light. */
final class InfraredParameters implements ParameterTheme<Modules> {
    private static final List<String> NAMES =
            List.of("front", "front right", "front left", "right", "left", "rear", "ground right", "ground left");

    private final RobotReadings access;

    InfraredParameters(RobotReadings access) {
        this.access = access;
    }

    @Override
    public void describe(ParameterTable table, Modules modules) {
        describeDistances(table);
        describeProximity(table);
        describeGround(table);
        describeLight(table);
    }

    private void describeDistances(ParameterTable table) {
        distance(
                table,
                "distanceFront",
                "free way ahead by five infra-red sensors; dark things seem farther",
                Clearance::front);
        distance(
                table,
                "distanceLeft",
                "from the hull to the left, up to 50 mm; dark things seem farther",
                Clearance::left);
        distance(
                table,
                "distanceRight",
                "from the hull to the right, up to 50 mm; dark things seem farther",
                Clearance::right);
        distance(
                table,
                "distanceBack",
                "from the hull backward, up to 60 mm; dark things seem farther",
                Clearance::back);
    }

    private void distance(ParameterTable table, String name, String help, Function<Proximity, OptionalDouble> from) {
        table.add(Parameter.number(name, Unit.MM, help), access.proximity(seen -> {
            OptionalDouble mm = from.apply(seen);
            return mm.isPresent() ? Value.about(mm.getAsDouble(), Unit.MM) : Value.CLEAR;
        }));
    }

    private void describeProximity(ParameterTable table) {
        table.add(
                Parameter.list("prox", Unit.NONE, "0 nothing to 255 near: " + String.join(", ", NAMES)),
                access.proximity(seen ->
                        Value.many(seen.raw().stream().map(RobotReadings::count).toList())));
        for (int sensor = 0; sensor < Proximity.SENSORS; sensor++) {
            int index = sensor;
            table.add(
                    Parameter.number("prox" + sensor, Unit.NONE, "0 nothing to 255 near, in the order of prox"),
                    access.proximity(seen -> RobotReadings.count(seen.value(index))));
        }
    }

    private void describeGround(ParameterTable table) {
        table.add(
                Parameter.number("groundRight", Unit.NONE, "what the ground reflects on the right, large when white"),
                access.proximity(seen -> RobotReadings.count(seen.value(Proximity.GROUND_RIGHT))));
        table.add(
                Parameter.number(
                        "groundLeft",
                        Unit.NONE,
                        "the same on the left; corrected for a slip of the firmware, which prox7 shows"),
                access.asked(Question.LIGHT, light -> groundLeft(light.numbers())));
    }

    private Value groundLeft(List<Integer> light) {
        return access.proximity(seen -> RobotReadings.count(Proximity.correctedGroundLeft(
                        seen.value(Proximity.GROUND_LEFT),
                        light.get(Proximity.GROUND_RIGHT),
                        light.get(Proximity.GROUND_LEFT))))
                .get();
    }

    private void describeLight(ParameterTable table) {
        table.add(
                Parameter.list(
                        "lightSensors", Unit.NONE, "0 bright to 255 dark (infra-red): " + String.join(", ", NAMES)),
                access.asked(
                        Question.LIGHT,
                        light -> Value.many(light.numbers().stream()
                                .map(RobotReadings::count)
                                .toList())));
        for (int sensor = 0; sensor < Proximity.SENSORS; sensor++) {
            int index = sensor;
            table.add(
                    Parameter.number("light" + sensor, Unit.NONE, "0 bright to 255 dark, in the order of prox"),
                    access.asked(
                            Question.LIGHT,
                            light -> RobotReadings.count(light.numbers().get(index))));
        }
    }
}
