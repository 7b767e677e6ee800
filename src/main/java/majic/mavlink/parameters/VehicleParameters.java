package majic.mavlink.parameters;

import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.function.ToLongFunction;
import majic.bot.BotProfile;
import majic.bot.MotionFailed;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.Motion;
import majic.driver.ParameterTable;
import majic.mavlink.frame.FrameCounts;
import majic.mavlink.message.AttitudeReport;
import majic.mavlink.message.BatteryReport;
import majic.mavlink.message.GlobalPosition;
import majic.mavlink.message.GpsFix;
import majic.mavlink.message.LocalPosition;
import majic.mavlink.message.VehicleHeartbeat;
import majic.mavlink.motion.FailsafeText;
import majic.mavlink.ranging.HullGap;
import majic.mavlink.session.FlightModes;
import majic.mavlink.session.VehicleSession;

/** What a vehicle reports, as parameters. */
public final class VehicleParameters {
    private static final int MM_PER_M = 1000;

    /** Modes in which an aircraft stays where it is, or comes down or home by itself. */
    private static final List<String> SAFE_IN_THE_AIR = List.of(
            "LOITER",
            "ALT_HOLD",
            "POSHOLD",
            "BRAKE",
            "LAND",
            "RTL",
            "SMART_RTL",
            "SURFACE",
            "HOLD",
            "RETURN",
            "CIRCLE");

    private final VehicleAccess access;

    /** Describes nothing yet. */
    public VehicleParameters(VehicleAccess access) {
        this.access = access;
    }

    /** Describes what every vehicle has. */
    public void describe(ParameterTable table) {
        describeState(table);
        describePlace(table);
        table.add(
                Parameter.number("battery", Unit.PERCENT, "charge left"),
                battery(BatteryReport::percent, Unit.PERCENT));
        table.add(Parameter.number("voltage", Unit.V, "of the battery"), battery(BatteryReport::volts, Unit.V));
        count(table, "lostFrames", "frames that did not arrive", FrameCounts::lost);
        count(table, "damagedFrames", "frames that arrived damaged", FrameCounts::damaged);
    }

    private Supplier<Value> battery(Function<BatteryReport, OptionalDouble> reader, Unit unit) {
        return access.read(open -> {
            OptionalDouble value = open.session()
                    .reports()
                    .battery(VehicleAccess.OLD_S)
                    .map(reader)
                    .orElse(OptionalDouble.empty());
            return value.isPresent() ? Value.of(value.getAsDouble(), unit) : VehicleAccess.NOT_REPORTED;
        });
    }

    private void describeState(ParameterTable table) {
        table.add(
                Parameter.text("model", "the kind of vehicle, and the version of its autopilot"),
                access.read(open -> Value.text(title(open))));
        table.add(
                Parameter.number("system", Unit.NONE, "its number, by which vehicles on one connection differ"),
                access.read(open -> Value.of(open.session().system(), Unit.NONE)));
        table.add(Parameter.text("mode", "the mode of the autopilot"), access.read(VehicleParameters::modeNow))
                .moves(this::setMode);
        table.add(
                Parameter.yesNo("armed", "whether its motors may turn"),
                access.newest(VehicleHeartbeat.class, heartbeat -> Value.yesNo(heartbeat.armed())));
        table.add(Parameter.text("message", "the newest text of the autopilot"), access.read(open -> {
            String text = open.session().texts().newest();
            return text.isEmpty() ? VehicleAccess.NOT_REPORTED : Value.text(text);
        }));
        table.add(
                Parameter.text("failsafe", "what the vehicle does when MAJIC ends without stopping it"),
                access.read(open -> Value.text(FailsafeText.of(open.session()))));
    }

    private static String title(VehicleAccess.Parts open) {
        return open.session().vehicle().title()
                + open.session().version().map(version -> " " + version).orElse("");
    }

    private static Value modeNow(VehicleAccess.Parts open) {
        return open.session()
                .reports()
                .newest(VehicleHeartbeat.class, VehicleAccess.OLD_S)
                .map(heartbeat -> Value.text(open.session().modes().name(heartbeat.customMode())))
                .orElse(VehicleAccess.NOT_REPORTED);
    }

    /** Returns the names of the modes that {@code set mode} accepts for the vehicle of a session, in order. */
    public static List<String> settableModes(VehicleSession session) {
        boolean all = session.vehicle().isOnSurface();
        return session.modes().names().stream()
                .filter(name -> all || SAFE_IN_THE_AIR.contains(name))
                .toList();
    }

    private void setMode(List<Value> values, Motion motion) {
        VehicleAccess.Parts open = access.alone();
        FlightModes modes = open.session().modes();
        String name = values.get(0).toString().toUpperCase(Locale.ROOT);
        if (modes.number(name).isEmpty()) {
            throw new MotionFailed(name + " is no mode of this vehicle; there are " + String.join(", ", modes.names()));
        }
        if (!open.session().vehicle().isOnSurface() && !SAFE_IN_THE_AIR.contains(name)) {
            throw new MotionFailed("MAJIC does not set " + name + " for a "
                    + open.session().vehicle().title() + ", which may then go anywhere");
        }
        open.motion().setMode(name, motion);
    }

    private void describePlace(ParameterTable table) {
        table.add(
                Parameter.number("latitude", Unit.LAT_LON, "north positive"),
                place(position -> Value.of(position.latitudeE7() / 1e7, Unit.LAT_LON)));
        table.add(
                Parameter.number("longitude", Unit.LAT_LON, "east positive"),
                place(position -> Value.of(position.longitudeE7() / 1e7, Unit.LAT_LON)));
        table.add(
                Parameter.number("altitude", Unit.MM, "above its home position"),
                place(position -> Value.of(position.aboveHomeMm(), Unit.MM)));
        table.add(
                Parameter.number("climbRate", Unit.MM_PER_S, "up positive"),
                place(position -> Value.of(-position.downMmPerSec(), Unit.MM_PER_S)));
        table.add(
                Parameter.number("groundSpeed", Unit.MM_PER_S, "over the ground, in whatever direction"),
                access.newest(
                        LocalPosition.class,
                        position -> Value.of(
                                MM_PER_M * Math.hypot(position.northMPerSec(), position.eastMPerSec()),
                                Unit.MM_PER_S)));
        table.add(
                Parameter.number("roll", Unit.DEG, "right side down positive"),
                access.newest(AttitudeReport.class, attitude -> degrees(attitude.rollDeg())));
        table.add(
                Parameter.number("pitch", Unit.DEG, "front up positive"),
                access.newest(AttitudeReport.class, attitude -> degrees(attitude.pitchDeg())));
        table.add(
                Parameter.number("satellites", Unit.NONE, "satellites that its receiver uses"),
                access.newest(
                        GpsFix.class,
                        fix -> fix.countsSatellites()
                                ? Value.of(fix.satellites(), Unit.NONE)
                                : VehicleAccess.NOT_REPORTED));
        table.add(
                Parameter.text("fix", "how good the position by satellites is"),
                access.newest(GpsFix.class, fix -> Value.text(fix.title())));
    }

    private static Value degrees(double degrees) {
        return Double.isFinite(degrees) ? Value.of(degrees, Unit.DEG) : VehicleAccess.NOT_REPORTED;
    }

    private Supplier<Value> place(Function<GlobalPosition, Value> reader) {
        return access.newest(
                GlobalPosition.class,
                position -> position.isKnown() ? reader.apply(position) : Value.unknown("no position yet"));
    }

    private void count(ParameterTable table, String name, String help, ToLongFunction<FrameCounts> counter) {
        table.add(
                Parameter.number(name, Unit.NONE, help),
                access.read(open -> Value.of(counter.applyAsLong(open.session().counts()), Unit.NONE)));
    }

    /**
     * Describes the distances on the sides of a vehicle that measures some.
     *
     * @param profile the size of the vehicle
     */
    public void describeRanges(ParameterTable table, Supplier<BotProfile> profile) {
        for (HullGap side : HullGap.values()) {
            table.add(
                    Parameter.number(side.parameter(), Unit.MM, side.help()),
                    access.read(open -> open.ranges().gap(side, profile.get().bodyMm())));
        }
    }
}
