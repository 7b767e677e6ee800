package majic.aibo.parameters;

import java.util.Optional;
import majic.aibo.body.DogState;
import majic.aibo.body.Sensor;
import majic.aibo.body.SensorReadings;
import majic.aibo.urbi.UrbiVersion;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;

/** What the infra-red beams meet, in mm where the dog has cm. */
final class RangeParameters implements ParameterTheme<UrbiVersion> {
    private final DogState dog;
    private final SensorReadings senses;

    RangeParameters(DogState dog) {
        this.dog = dog;
        this.senses = dog.senses();
    }

    @Override
    public void describe(ParameterTable table, UrbiVersion version) {
        table.add(
                Parameter.number("distanceFront", Unit.MM, "from the hull to the nearest thing in its way ahead"),
                this::front);
        beam(table, "distanceNear", Sensor.NEAR, "the near sensor in the head, 57 to 500 mm");
        beam(table, "distance", Sensor.FAR, "the far sensor in the head, 200 to 1500 mm");
        beam(table, "distanceFar", Sensor.FAR, "the same as distance");
        beam(table, "distanceChest", Sensor.CHEST, "the sensor in the chest, 190 to 900 mm");
    }

    private void beam(ParameterTable table, String name, Sensor sensor, String help) {
        table.add(Parameter.number(name, Unit.MM, help), () -> range(sensor));
    }

    private Value range(Sensor sensor) {
        return senses.number(sensor).isEmpty()
                ? senses.unknown(sensor)
                : clearOr(dog.infraRed().rangeMm(sensor));
    }

    private Value front() {
        return dog.infraRed().isKnown() ? clearOr(dog.frontMm()) : senses.unknown(Sensor.NEAR);
    }

    private static Value clearOr(Optional<Double> mm) {
        return mm.map(distance -> Value.of(distance, Unit.MM)).orElse(Value.CLEAR);
    }
}
