package majic.ros.parameters;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.ros.message.RangeMessage;
import majic.ros.readings.HullSide;
import majic.ros.readings.NoEcho;
import majic.ros.readings.RosReadings;
import majic.ros.readings.RosSensors;
import majic.ros.readings.RosTopic;
import majic.ros.readings.ScanPoints;
import majic.ros.readings.ScanSummary;

/** What the laser scanner and the single beams see. */
final class RosRangingParameters implements ParameterTheme<RosSensors> {
    private final RosAccess access;
    private final DoubleSupplier radiusMm;
    private volatile NoEcho noEcho = NoEcho.AUTO;

    /**
     * Creates the theme.
     *
     * @param radiusMm of the robot
     */
    RosRangingParameters(RosAccess access, DoubleSupplier radiusMm) {
        this.access = access;
        this.radiusMm = radiusMm;
    }

    @Override
    public void describe(ParameterTable table, RosSensors sensors) {
        if (sensors.scan().isEmpty() && sensors.ranges().isEmpty()) {
            return;
        }
        for (HullSide side : HullSide.values()) {
            table.add(
                    Parameter.number(side.parameter(), Unit.MM, side.help()),
                    access.read(readings -> readings.distance(side, radiusMm.getAsDouble(), noEcho)));
        }
        table.add(
                        Parameter.choice(
                                "noEcho",
                                Arrays.stream(NoEcho.values()).map(NoEcho::word).toList(),
                                "what beams without an echo mean; auto: clear if the scanner sees all that is near"),
                        () -> Value.text(noEcho.word()))
                .kept()
                .writes(values ->
                        noEcho = NoEcho.valueOf(values.get(0).toString().toUpperCase(Locale.ROOT)));
        if (sensors.scan().isPresent()) {
            describeScan(table);
        }
        sensors.ranges().forEach(topic -> describeRange(table, topic));
    }

    private void describeScan(ParameterTable table) {
        table.add(
                Parameter.list(
                        "scan",
                        Unit.MM,
                        "nearest echo in twelve sectors of 30 degrees, from ahead to the left; from the turning centre"),
                scan((points, summary) -> summary.values()));
        table.add(
                Parameter.number("scanNearest", Unit.MM, "distance of the nearest echo from the turning centre"),
                scan((points, summary) -> summary.nearestMm(points)));
        table.add(
                Parameter.number("scanBearing", Unit.DEG, "direction of the nearest echo, left positive"),
                scan((points, summary) -> summary.bearing(points)));
        table.add(
                Parameter.number("scanBeams", Unit.NONE, "how many beams the scan has"),
                scan((points, summary) -> Value.of(points.beams(), Unit.NONE)));
        table.add(
                Parameter.number("scanEchoes", Unit.NONE, "how many beams have an echo"),
                scan((points, summary) -> Value.of(points.echoes(), Unit.NONE)));
    }

    private Supplier<Value> scan(BiFunction<ScanPoints, ScanSummary, Value> reader) {
        return access.read(readings -> readings.scan()
                .get()
                .map(points -> reader.apply(points, ScanSummary.of(points)))
                .orElseGet(() -> readings.scan().unknown()));
    }

    private void describeRange(ParameterTable table, RosTopic topic) {
        table.add(
                Parameter.number(rangeName(topic.name()), Unit.MM, "what the sensor of " + topic.name() + " measures"),
                access.read(readings -> range(readings, topic)));
    }

    private static Value range(RosReadings readings, RosTopic topic) {
        Optional<RangeMessage> reading = readings.range(topic).get();
        if (reading.isEmpty()) {
            return readings.range(topic).unknown();
        }
        return reading.get().rangeMm().isEmpty()
                ? Value.unknown("no echo")
                : Value.of(reading.get().rangeMm().getAsDouble(), Unit.MM);
    }

    /** {@code /robot1/sonar/left} becomes {@code rangeLeft}; {@code /ps0} becomes {@code rangePs0}. */
    static String rangeName(String topic) {
        String last = topic.substring(topic.lastIndexOf('/') + 1).replaceAll("[^A-Za-z0-9]", "");
        return last.isEmpty() ? "range" : "range" + last.substring(0, 1).toUpperCase(Locale.ROOT) + last.substring(1);
    }
}
