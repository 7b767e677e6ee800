package majic.ros.parameters;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.ros.message.BatteryMessage;
import majic.ros.message.BatteryMessage.Supply;
import majic.ros.message.CompressedPicture;
import majic.ros.message.ImuMessage;
import majic.ros.message.Orientation;
import majic.ros.message.Vector;
import majic.ros.readings.ActiveHazards;
import majic.ros.readings.RequestedReading;
import majic.ros.readings.RosReadings;
import majic.ros.readings.RosSensors;

/** What the robot's sensors report, apart from ranges and joints: each parameter is a row of a table. */
final class RosReportedParameters {
    private static final double BYTES_PER_KB = 1000;
    private static final Value NOT_MEASURED = Value.unknown("the inertial unit does not measure it");

    private final RosAccess access;

    RosReportedParameters(RosAccess access) {
        this.access = access;
    }

    /** Bumpers, cliff sensors, and what else stops a base by itself. */
    void contacts(ParameterTable table, RosSensors sensors) {
        if (sensors.hazards().isEmpty() && sensors.contacts().isEmpty()) {
            return;
        }
        table.add(
                Parameter.yesNo("bumped", "whether a bumper is pressed or the base reports a stall"),
                hazards(hazards -> Value.yesNo(hazards.isBumped())));
        table.add(
                Parameter.text(
                        "hazards", "what bumpers, cliff sensors and the base report: \"bump left\", or \"none\""),
                hazards(hazards -> Value.text(hazardWords(hazards.now()))));
    }

    private Supplier<Value> hazards(Function<ActiveHazards, Value> reader) {
        return access.read(readings ->
                readings.hasContacts() ? reader.apply(readings.hazards()) : Value.unknown("no reading of late"));
    }

    private static String hazardWords(List<ActiveHazards.Report> hazards) {
        return hazards.isEmpty()
                ? "none"
                : hazards.stream().map(ActiveHazards.Report::words).collect(Collectors.joining(", "));
    }

    /** The battery. */
    void power(ParameterTable table, RosSensors sensors) {
        if (sensors.battery().isEmpty()) {
            return;
        }
        table.add(
                Parameter.number("battery", Unit.PERCENT, "charge left"),
                battery(battery -> percent(battery.percent())));
        table.add(Parameter.number("voltage", Unit.V, "of the battery"), battery(battery -> volts(battery.volts())));
        List<String> words = Arrays.stream(Supply.values()).map(Supply::words).toList();
        table.add(
                Parameter.choice("charging", words, "what the charger does"),
                battery(battery -> supply(battery.supply())));
    }

    private Supplier<Value> battery(Function<BatteryMessage, Value> reader) {
        return access.read(readings -> readings.battery()
                .get()
                .map(reader)
                .orElseGet(() -> readings.battery().unknown()));
    }

    private static Value percent(OptionalDouble percent) {
        return percent.isEmpty()
                ? Value.unknown("this robot does not report its charge")
                : Value.of(percent.getAsDouble(), Unit.PERCENT);
    }

    private static Value volts(OptionalDouble volts) {
        return volts.isEmpty()
                ? Value.unknown("this robot does not report its voltage")
                : Value.of(volts.getAsDouble(), Unit.V);
    }

    private static Value supply(Supply supply) {
        return supply == Supply.UNKNOWN ? Value.unknown("this robot does not report it") : Value.text(supply.words());
    }

    /** The inertial unit; subscribed to while something reads it. */
    void inertial(ParameterTable table, RosSensors sensors) {
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

    /** The camera; subscribed to while a panel shows it or something reads these parameters. */
    void camera(ParameterTable table, RosSensors sensors) {
        if (sensors.camera().isEmpty()) {
            return;
        }
        table.add(
                Parameter.text("camera", "format and size of the newest picture; requested when read"),
                access.requested(RosReadings::camera, RosReportedParameters::pictureWords));
        table.add(
                Parameter.number("cameraAge", Unit.MS, "time since the newest picture; requests none"),
                access.read(readings -> age(readings.camera())));
    }

    private static Value pictureWords(CompressedPicture picture) {
        return Value.text(picture.format() + ", " + Value.plain(picture.size() / BYTES_PER_KB) + " kB");
    }

    private static Value age(Optional<RequestedReading<CompressedPicture>> camera) {
        double ageS = camera.map(RequestedReading::ageS).orElse(Double.POSITIVE_INFINITY);
        return Double.isFinite(ageS) ? Value.of(ageS * 1000, Unit.MS) : Value.unknown("no picture yet");
    }
}
