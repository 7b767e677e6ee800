package majic.pioneer.parameters;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import java.util.function.ToLongFunction;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.pioneer.arcos.ConfigField;
import majic.pioneer.arcos.PacketCounts;
import majic.pioneer.arcos.PioneerIdentity;
import majic.pioneer.arcos.ReportKind;
import majic.pioneer.state.Charging;
import majic.pioneer.state.EncoderTicks;
import majic.pioneer.state.Equipment;
import majic.pioneer.state.PioneerState;
import majic.pioneer.state.Power;
import majic.pioneer.state.Scaling;

/**
 * What the robot reports and that cannot be set, apart from contacts and sonars: each parameter is a row of a table.
 */
final class ReportedParameters {
    private final PioneerAccess access;

    ReportedParameters(PioneerAccess access) {
        this.access = access;
    }

    /** Controller, battery and charger. */
    void power(ParameterTable table, Equipment equipment) {
        number(
                table,
                "temperature",
                Unit.CELSIUS,
                "of the controller, where it has a thermometer",
                whole(PioneerState::temperatureC, Unit.CELSIUS));
        number(
                table,
                "faults",
                Unit.NONE,
                "the controller's fault flags as one number, 0 when all is well",
                whole(PioneerState::faults, Unit.NONE));
        number(
                table,
                "voltage",
                Unit.V,
                "of the battery; charge a 12 V robot below 11.5",
                access.state(state -> Value.of(state.volts(), Unit.V)));
        number(
                table,
                "battery",
                Unit.PERCENT,
                "charge, on robots that report it",
                power(power -> charge(power.percent())));
        number(
                table,
                "lowVoltage",
                Unit.V,
                "below it the robot gives an alarm, or never",
                access.configOrNever(ConfigField.LOWBATTERY, Unit.V, 10));
        List<String> words =
                Arrays.stream(Charging.values()).map(Charging::words).toList();
        table.add(
                Parameter.choice("charging", words, "what the charger does"),
                power(power -> charging(power.charging())));
        table.add(
                Parameter.yesNo("charger", "whether a charger is connected and its supply good"),
                power(power -> Value.yesNo(power.chargerConnected())));
    }

    /** The motion sensors: wheels, encoders, compass, gyro. */
    void motion(ParameterTable table, Equipment equipment) {
        Scaling scaling = equipment.model().scaling();
        wheel(table, "wheelLeft", "speed of the left wheel", state -> scaling.leftMmPerSec(state.sip()));
        wheel(table, "wheelRight", "speed of the right wheel", state -> scaling.rightMmPerSec(state.sip()));
        encoder(table, "encoderLeft", "ticks of the left wheel; requested when read", EncoderTicks::left);
        encoder(table, "encoderRight", "ticks of the right wheel; requested when read", EncoderTicks::right);
        number(
                table,
                "compass",
                Unit.DEG,
                "as the compass shows it, 2 to 358; unknown without one and at 0",
                whole(PioneerState::compassDeg, Unit.DEG));
        if (equipment.gyro()) {
            number(
                    table,
                    "gyro",
                    Unit.DEG_PER_S,
                    "turn rate, left positive; requested when read",
                    access.report(ReportKind.GYRO, state -> turnRate(state.gyroDegPerSec())));
        }
    }

    /** The names and versions of the robot, and settings of its controller. */
    void identity(ParameterTable table, Equipment equipment) {
        text(table, "model", "the model as it reports it", identity(PioneerIdentity::subclass));
        text(table, "robotName", "the name that is stored in it", identity(PioneerIdentity::name));
        text(table, "serialNumber", "of the controller", access.config(ConfigField.SERNUM));
        text(table, "firmware", "version of the controller's program", access.config(ConfigField.FIRMWARE));
        text(
                table,
                "bootLoader",
                "version of the program that starts the firmware",
                access.config(ConfigField.BOOTLOADER));
        number(
                table,
                "ticksPerMm",
                Unit.NONE,
                "encoder ticks for a millimetre",
                access.config(ConfigField.TICKSMM, Unit.NONE, 1));
        number(
                table,
                "watchdog",
                Unit.MS,
                "the robot stops after this time without a packet, or never",
                access.configOrNever(ConfigField.WATCHDOG, Unit.MS, 1));
        number(
                table,
                "cycle",
                Unit.MS,
                "from one packet of the robot to the next",
                access.config(ConfigField.SIPCYCLE, Unit.MS, 1));
    }

    /** The quality of the link. */
    void link(ParameterTable table, Equipment equipment) {
        number(
                table,
                "packetRate",
                Unit.NONE,
                "state packets from the robot a second; about 10",
                access.state(state -> Value.of(Math.round(10 * state.sipsPerSec()) / 10.0, Unit.NONE)));
        number(
                table,
                "longestSilence",
                Unit.MS,
                "the longest time between two of them since it was connected",
                access.state(state -> Value.of(state.longestSilenceS() * 1000, Unit.MS)));
        number(
                table,
                "damagedPackets",
                Unit.NONE,
                "with a wrong checksum, since it was connected",
                count(PacketCounts::damagedPackets));
        number(
                table,
                "skippedBytes",
                Unit.NONE,
                "that belonged to no whole packet, since it was connected",
                count(PacketCounts::skippedBytes));
    }

    private static void number(ParameterTable table, String name, Unit unit, String help, Supplier<Value> reader) {
        table.add(Parameter.number(name, unit, help), reader);
    }

    private static void text(ParameterTable table, String name, String help, Supplier<Value> reader) {
        table.add(Parameter.text(name, help), reader);
    }

    private void wheel(ParameterTable table, String name, String help, ToDoubleFunction<PioneerState> speed) {
        number(
                table,
                name,
                Unit.MM_PER_S,
                help,
                access.scaled(state -> Value.of(speed.applyAsDouble(state), Unit.MM_PER_S)));
    }

    private void encoder(ParameterTable table, String name, String help, ToDoubleFunction<EncoderTicks> ticks) {
        number(
                table,
                name,
                Unit.NONE,
                help,
                access.report(
                        ReportKind.ENCODERS,
                        state -> state.encoders().map(counts -> Value.of(ticks.applyAsDouble(counts), Unit.NONE))));
    }

    private Supplier<Value> whole(Function<PioneerState, OptionalInt> reader, Unit unit) {
        return access.state(state -> {
            OptionalInt reported = reader.apply(state);
            return reported.isEmpty() ? PioneerAccess.NOT_REPORTED : Value.of(reported.getAsInt(), unit);
        });
    }

    private Supplier<Value> power(Function<Power, Value> reader) {
        return access.state(state -> reader.apply(state.power()));
    }

    private Supplier<Value> identity(Function<PioneerIdentity, String> part) {
        return access.session(open -> {
            PioneerIdentity known = open.identity();
            return known == null ? Value.unknown("not connected") : Value.text(part.apply(known));
        });
    }

    private Supplier<Value> count(ToLongFunction<PacketCounts> part) {
        return access.session(open -> {
            PacketCounts counts = open.packetCounts();
            return counts == null ? PioneerAccess.missing(open) : Value.of(part.applyAsLong(counts), Unit.NONE);
        });
    }

    private static Value charge(OptionalInt percent) {
        return percent.isEmpty()
                ? Value.unknown("this robot reports only its voltage")
                : Value.of(percent.getAsInt(), Unit.PERCENT);
    }

    private static Value charging(Charging charging) {
        return charging == Charging.UNKNOWN ? PioneerAccess.NOT_REPORTED : Value.text(charging.words());
    }

    private static Optional<Value> turnRate(OptionalDouble degPerSec) {
        return degPerSec.isEmpty() ? Optional.empty() : Optional.of(Value.of(degPerSec.getAsDouble(), Unit.DEG_PER_S));
    }
}
