package majicsim.mavlink;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import majicsim.mavlink.message.Message;
import majicsim.mavlink.message.MessageType;

/** The messages that a vehicle sends about itself. */
final class Telemetry {
    private static final int ARDUPILOT = 3;
    private static final int MAVLINK_VERSION = 3;

    /** As in the captured session: all sensors of ArduPilot's own simulation. */
    private static final long SENSORS = 322_034_735L;

    private static final long SENSORS_ON = 320_986_159L;
    private static final long PRE_ARM_CHECK = 1L << 28;

    /** As in the captured session; 4.6.0, an official release. */
    private static final long CAPABILITIES = 0xF1EFL;

    private static final long FIRMWARE = 0x040600FFL;
    private static final long UTC_AT_START_US = 1_795_817_844_960_000L;
    private static final int UNUSED = 65_535;
    private static final int NO_TEMPERATURE = 32_767;
    private static final int FIX_3D = 3;
    private static final int RELATIVE_HEIGHT_FRAME = 6;
    private static final int BODY_FRAME = 12;
    private static final int LASER = 0;
    private static final int DOWN = 25;
    private static final int QUATERNION_PARTS = 4;
    private static final int[] SIDES_DEG = {0, 90, 180, 270};

    private final Vehicle vehicle;
    private final Board board;
    private final RangeFinders rangeFinders;
    private final Map<MessageType, Supplier<List<Message>>> makers = new EnumMap<>(MessageType.class);

    Telemetry(Vehicle vehicle, RangeFinders rangeFinders) {
        this.vehicle = vehicle;
        this.board = vehicle.board();
        this.rangeFinders = rangeFinders;
        one(MessageType.HEARTBEAT, this::heartbeat);
        one(MessageType.SYS_STATUS, this::status);
        one(MessageType.SYSTEM_TIME, this::time);
        one(MessageType.GPS_RAW_INT, this::satellites);
        one(MessageType.ATTITUDE, this::attitude);
        one(MessageType.LOCAL_POSITION_NED, this::localPosition);
        one(MessageType.GLOBAL_POSITION_INT, this::globalPosition);
        one(MessageType.MISSION_CURRENT, () -> new Message(MessageType.MISSION_CURRENT));
        one(MessageType.RC_CHANNELS, this::sticks);
        one(MessageType.VFR_HUD, this::display);
        makers.put(MessageType.POSITION_TARGET_LOCAL_NED, this::localTarget);
        makers.put(MessageType.POSITION_TARGET_GLOBAL_INT, this::globalTarget);
        makers.put(MessageType.DISTANCE_SENSOR, this::distances);
        one(MessageType.BATTERY_STATUS, this::battery);
        one(MessageType.AUTOPILOT_VERSION, this::firmware);
        one(MessageType.RANGEFINDER, this::rangeFinder);
        makers.put(MessageType.HOME_POSITION, this::home);
        one(MessageType.EXTENDED_SYS_STATE, this::landing);
        one(MessageType.OBSTACLE_DISTANCE, this::obstacles);
    }

    private void one(MessageType type, Supplier<Message> maker) {
        makers.put(type, () -> List.of(maker.get()));
    }

    boolean has(MessageType type) {
        return makers.containsKey(type);
    }

    /** What is sent now as messages of a type: often one, none without a target, several distances. */
    List<Message> messages(MessageType type) {
        Supplier<List<Message>> maker = makers.get(type);
        return maker == null ? List.of() : maker.get();
    }

    private Message timed(MessageType type) {
        return new Message(type).with("time_boot_ms", board.boot().millis());
    }

    private long micros() {
        return board.boot().millis() * 1000;
    }

    private Message heartbeat() {
        return new Message(MessageType.HEARTBEAT)
                .with("custom_mode", vehicle.mode())
                .with("type", board.kind().type())
                .with("autopilot", ARDUPILOT)
                .with("base_mode", vehicle.baseMode())
                .with("system_status", vehicle.systemStatus())
                .with("mavlink_version", MAVLINK_VERSION);
    }

    private Message status() {
        Battery battery = board.battery();
        boolean canArm = board.boot().armingFailures().isEmpty();
        return new Message(MessageType.SYS_STATUS)
                .with("onboard_control_sensors_present", SENSORS)
                .with("onboard_control_sensors_enabled", SENSORS_ON)
                .with("onboard_control_sensors_health", canArm ? SENSORS : SENSORS & ~PRE_ARM_CHECK)
                .with("voltage_battery", battery.volts() * 1000)
                .with("current_battery", battery.amperes() * 100)
                .with("battery_remaining", battery.percent());
    }

    private Message time() {
        return timed(MessageType.SYSTEM_TIME)
                .with("time_unix_usec", board.boot().hasFix() ? UTC_AT_START_US + micros() : 0);
    }

    private Message satellites() {
        Message message = new Message(MessageType.GPS_RAW_INT);
        if (!board.boot().hasFix()) {
            return message.with("eph", UNUSED).with("epv", UNUSED);
        }
        Motion now = vehicle.motion();
        return message.with("time_usec", micros())
                .with("lat", latitude(now))
                .with("lon", longitude(now))
                .with("alt", altitude(now) * 1000)
                .with("eph", 121)
                .with("epv", 200)
                .with("vel", now.groundSpeed() * 100)
                .with(
                        "cog",
                        centidegrees(Math.atan2(
                                board.filter().eastSpeed(now), board.filter().northSpeed(now))))
                .with("fix_type", FIX_3D)
                .with("satellites_visible", 10);
    }

    private int latitude(Motion now) {
        return board.filter().latitude(board.filter().north(now));
    }

    private int longitude(Motion now) {
        return board.filter().longitude(board.filter().east(now));
    }

    private static double altitude(Motion now) {
        return PositionFilter.FLOOR_M + now.height();
    }

    /** A direction as 0 to 35999. */
    private static long centidegrees(double radians) {
        return Math.floorMod(Math.round(Math.toDegrees(radians) * 100), 36_000L);
    }

    private Message attitude() {
        Motion now = vehicle.motion();
        return timed(MessageType.ATTITUDE)
                .with("roll", now.roll())
                .with("pitch", now.pitch())
                .with("yaw", now.yaw())
                .with("yawspeed", now.yawRate());
    }

    /** Before the filter uses satellites there is no place, and the height is once that above the sea (sheet 6). */
    private Message localPosition() {
        Motion now = vehicle.motion();
        Message message = timed(MessageType.LOCAL_POSITION_NED);
        if (!board.boot().hasPosition()) {
            return message.with("z", board.boot().hasOrigin() ? PositionFilter.FLOOR_M : 0);
        }
        return message.with("x", board.filter().north(now))
                .with("y", board.filter().east(now))
                .with("z", -now.height())
                .with("vx", board.filter().northSpeed(now))
                .with("vy", board.filter().eastSpeed(now))
                .with("vz", -now.climb());
    }

    private Message globalPosition() {
        Motion now = vehicle.motion();
        Message message = timed(MessageType.GLOBAL_POSITION_INT).with("hdg", centidegrees(now.yaw()));
        if (!board.boot().hasFix()) {
            return message;
        }
        return message.with("lat", latitude(now))
                .with("lon", longitude(now))
                .with("alt", altitude(now) * 1000)
                .with("relative_alt", (now.height() - board.filter().homeHeight()) * 1000)
                .with("vx", board.filter().northSpeed(now) * 100)
                .with("vy", board.filter().eastSpeed(now) * 100)
                .with("vz", -now.climb() * 100);
    }

    private Message sticks() {
        Message message = timed(MessageType.RC_CHANNELS).with("chancount", 16).with("rssi", 255);
        for (int channel = 1; channel <= RadioControl.CHANNELS; channel++) {
            message.with("chan" + channel + "_raw", board.radio().micros(channel));
        }
        return message;
    }

    private Message display() {
        Motion now = vehicle.motion();
        return new Message(MessageType.VFR_HUD)
                .with("airspeed", now.groundSpeed())
                .with("groundspeed", now.groundSpeed())
                .with("alt", altitude(now))
                .with("climb", now.climb())
                .with("heading", centidegrees(now.yaw()) / 100)
                .with("throttle", vehicle.throttlePercent());
    }

    private List<Message> localTarget() {
        PositionTarget target = vehicle.aimed();
        if (target == null) {
            return List.of();
        }
        return List.of(timed(MessageType.POSITION_TARGET_LOCAL_NED)
                .with("coordinate_frame", PositionTarget.LOCAL_NED)
                .with("type_mask", target.mask())
                .with("x", target.x())
                .with("y", target.y())
                .with("z", target.z())
                .with("vx", target.vx())
                .with("vy", target.vy())
                .with("vz", target.vz())
                .with("yaw", target.yaw())
                .with("yaw_rate", target.yawRate()));
    }

    private List<Message> globalTarget() {
        PositionTarget target = vehicle.aimed();
        if (target == null || !target.has(PositionTarget.HORIZONTAL_POSITION)) {
            return List.of();
        }
        return List.of(timed(MessageType.POSITION_TARGET_GLOBAL_INT)
                .with("coordinate_frame", RELATIVE_HEIGHT_FRAME)
                .with("type_mask", 0xFDF8)
                .with("lat_int", board.filter().latitude(target.x()))
                .with("lon_int", board.filter().longitude(target.y()))
                .with("alt", -target.z() - board.filter().homeHeight()));
    }

    /** One range finder for each side, and one downwards where a vehicle flies. */
    private List<Message> distances() {
        List<Message> messages = new ArrayList<>();
        for (int id = 0; id < SIDES_DEG.length; id++) {
            messages.add(distance(id, SIDES_DEG[id] / 45, rangeFinders.fromHull(SIDES_DEG[id])));
        }
        if (board.kind() == VehicleKind.COPTER) {
            long below = Math.round(vehicle.motion().height() * 100);
            messages.add(distance(SIDES_DEG.length, DOWN, (int) Math.min(RangeFinders.MOST_CM + 1, below)));
        }
        return messages;
    }

    private Message distance(int id, int orientation, int centimetres) {
        return timed(MessageType.DISTANCE_SENSOR)
                .with("min_distance", RangeFinders.LEAST_CM)
                .with("max_distance", RangeFinders.MOST_CM)
                .with("current_distance", centimetres)
                .with("type", LASER)
                .with("id", id)
                .with("orientation", orientation);
    }

    private Message rangeFinder() {
        return new Message(MessageType.RANGEFINDER).with("distance", rangeFinders.fromHull(0) / 100.0);
    }

    private Message obstacles() {
        Message message = new Message(MessageType.OBSTACLE_DISTANCE)
                .with("time_usec", micros())
                .with("min_distance", RangeFinders.LEAST_CM)
                .with("max_distance", RangeFinders.MOST_CM)
                .with("sensor_type", LASER)
                .with("increment", RangeFinders.DEGREES_A_BEAM)
                .with("frame", BODY_FRAME);
        int[] distances = rangeFinders.around();
        for (int beam = 0; beam < distances.length; beam++) {
            message.with("distances", beam, distances[beam]);
        }
        return message;
    }

    private Message battery() {
        Battery battery = board.battery();
        Message message = new Message(MessageType.BATTERY_STATUS)
                .with("current_consumed", battery.usedMah())
                .with("energy_consumed", battery.usedJ() / 100)
                .with("temperature", NO_TEMPERATURE)
                .with("current_battery", battery.amperes() * 100)
                .with("battery_remaining", battery.percent())
                .with("charge_state", battery.chargeState());
        for (int cell = 0; cell < 10; cell++) {
            message.with("voltages", cell, cell == 0 ? battery.volts() * 1000 : UNUSED);
        }
        return message;
    }

    private Message firmware() {
        return new Message(MessageType.AUTOPILOT_VERSION)
                .with("capabilities", CAPABILITIES)
                .with("flight_sw_version", FIRMWARE);
    }

    /** Nothing until there is a home; as in the captured session, what is not known is not a number. */
    private List<Message> home() {
        Boot boot = board.boot();
        if (!boot.hasFix()) {
            return List.of();
        }
        PositionFilter filter = board.filter();
        Message message = new Message(MessageType.HOME_POSITION)
                .with("latitude", filter.latitude(filter.homeNorth()))
                .with("longitude", filter.longitude(filter.homeEast()))
                .with("altitude", (PositionFilter.FLOOR_M + filter.homeHeight()) * 1000)
                .with("x", boot.hasOrigin() ? filter.homeNorth() : Double.NaN)
                .with("y", boot.hasOrigin() ? filter.homeEast() : Double.NaN)
                .with("z", boot.hasOrigin() ? -filter.homeHeight() : Double.NaN)
                .with("time_usec", micros());
        for (int part = 0; part < QUATERNION_PARTS; part++) {
            message.with("q", part, Double.NaN);
        }
        return List.of(message);
    }

    private Message landing() {
        return new Message(MessageType.EXTENDED_SYS_STATE).with("landed_state", vehicle.landedState());
    }
}
