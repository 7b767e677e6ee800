package majicsim.mavlink.message;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * The messages of a vehicle and a ground station: number, CRC_EXTRA, and fields in the order on the wire, extensions
 * behind {@code +} (sheet 6 to 9, and the definitions of pymavlink). The names of fields are those of the definitions,
 * from which CRC_EXTRA follows.
 */
public enum MessageType {
    /** What a system is, its mode, and whether it is armed. */
    HEARTBEAT(
            0,
            50,
            "uint32_t custom_mode, uint8_t type, uint8_t autopilot, uint8_t base_mode, uint8_t system_status,"
                    + " uint8_t mavlink_version"),
    /** Sensors and battery. */
    SYS_STATUS(
            1,
            124,
            "uint32_t onboard_control_sensors_present, uint32_t onboard_control_sensors_enabled,"
                    + " uint32_t onboard_control_sensors_health, uint16_t load, uint16_t voltage_battery,"
                    + " int16_t current_battery, uint16_t drop_rate_comm, uint16_t errors_comm, uint16_t errors_count1,"
                    + " uint16_t errors_count2, uint16_t errors_count3, uint16_t errors_count4, int8_t battery_remaining +"
                    + " uint32_t onboard_control_sensors_present_extended, uint32_t onboard_control_sensors_enabled_extended,"
                    + " uint32_t onboard_control_sensors_health_extended"),
    /** Universal time and time since the boot. */
    SYSTEM_TIME(2, 137, "uint64_t time_unix_usec, uint32_t time_boot_ms"),
    /** Wish for a mode, the old way. */
    SET_MODE(11, 89, "uint32_t custom_mode, uint8_t target_system, uint8_t base_mode"),
    /** Question for one parameter. */
    PARAM_REQUEST_READ(
            20, 214, "int16_t param_index, uint8_t target_system, uint8_t target_component, char param_id[16]"),
    /** Question for all parameters. */
    PARAM_REQUEST_LIST(21, 159, "uint8_t target_system, uint8_t target_component"),
    /** One parameter. */
    PARAM_VALUE(
            22,
            220,
            "float param_value, uint16_t param_count, uint16_t param_index, char param_id[16], uint8_t param_type"),
    /** New value of a parameter. */
    PARAM_SET(
            23,
            168,
            "float param_value, uint8_t target_system, uint8_t target_component, char param_id[16], uint8_t param_type"),
    /** The satellite receiver. */
    GPS_RAW_INT(
            24,
            24,
            "uint64_t time_usec, int32_t lat, int32_t lon, int32_t alt, uint16_t eph, uint16_t epv, uint16_t vel,"
                    + " uint16_t cog, uint8_t fix_type, uint8_t satellites_visible + int32_t alt_ellipsoid, uint32_t h_acc,"
                    + " uint32_t v_acc, uint32_t vel_acc, uint32_t hdg_acc, uint16_t yaw"),
    /** The first inertial sensor. */
    RAW_IMU(
            27,
            144,
            "uint64_t time_usec, int16_t xacc, int16_t yacc, int16_t zacc, int16_t xgyro, int16_t ygyro, int16_t zgyro,"
                    + " int16_t xmag, int16_t ymag, int16_t zmag + uint8_t id, int16_t temperature"),
    /** The first barometer. */
    SCALED_PRESSURE(
            29,
            115,
            "uint32_t time_boot_ms, float press_abs, float press_diff, int16_t temperature +"
                    + " int16_t temperature_press_diff"),
    /** Attitude and rates. */
    ATTITUDE(
            30,
            39,
            "uint32_t time_boot_ms, float roll, float pitch, float yaw, float rollspeed, float pitchspeed, float yawspeed"),
    /** Place and velocity from the origin of the filter. */
    LOCAL_POSITION_NED(32, 185, "uint32_t time_boot_ms, float x, float y, float z, float vx, float vy, float vz"),
    /** Place on the globe. */
    GLOBAL_POSITION_INT(
            33,
            104,
            "uint32_t time_boot_ms, int32_t lat, int32_t lon, int32_t alt, int32_t relative_alt, int16_t vx, int16_t vy,"
                    + " int16_t vz, uint16_t hdg"),
    /** Sticks in percent. */
    RC_CHANNELS_SCALED(
            34,
            237,
            "uint32_t time_boot_ms, int16_t chan1_scaled, int16_t chan2_scaled, int16_t chan3_scaled,"
                    + " int16_t chan4_scaled, int16_t chan5_scaled, int16_t chan6_scaled, int16_t chan7_scaled,"
                    + " int16_t chan8_scaled, uint8_t port, uint8_t rssi"),
    /** Outputs to motors and servos. */
    SERVO_OUTPUT_RAW(
            36,
            222,
            "uint32_t time_usec, uint16_t servo1_raw, uint16_t servo2_raw, uint16_t servo3_raw, uint16_t servo4_raw,"
                    + " uint16_t servo5_raw, uint16_t servo6_raw, uint16_t servo7_raw, uint16_t servo8_raw, uint8_t port +"
                    + " uint16_t servo9_raw, uint16_t servo10_raw, uint16_t servo11_raw, uint16_t servo12_raw,"
                    + " uint16_t servo13_raw, uint16_t servo14_raw, uint16_t servo15_raw, uint16_t servo16_raw"),
    /** One item of a mission, the old way; as "current 2" a place to go to. */
    MISSION_ITEM(
            39,
            254,
            "float param1, float param2, float param3, float param4, float x, float y, float z, uint16_t seq,"
                    + " uint16_t command, uint8_t target_system, uint8_t target_component, uint8_t frame, uint8_t current,"
                    + " uint8_t autocontinue + uint8_t mission_type"),
    /** Which item of the mission is next. */
    MISSION_CURRENT(42, 28, "uint16_t seq + uint16_t total, uint8_t mission_state, uint8_t mission_mode"),
    /** Question for the mission. */
    MISSION_REQUEST_LIST(43, 132, "uint8_t target_system, uint8_t target_component + uint8_t mission_type"),
    /** How many items a mission has. */
    MISSION_COUNT(44, 221, "uint16_t count, uint8_t target_system, uint8_t target_component + uint8_t mission_type"),
    /** Removes the mission. */
    MISSION_CLEAR_ALL(45, 232, "uint8_t target_system, uint8_t target_component + uint8_t mission_type"),
    /** A place was reached. */
    MISSION_ITEM_REACHED(46, 11, "uint16_t seq"),
    /** How the transfer of a mission ended. */
    MISSION_ACK(47, 153, "uint8_t target_system, uint8_t target_component, uint8_t type + uint8_t mission_type"),
    /** The navigation controller. */
    NAV_CONTROLLER_OUTPUT(
            62,
            183,
            "float nav_roll, float nav_pitch, float alt_error, float aspd_error, float xtrack_error, int16_t nav_bearing,"
                    + " int16_t target_bearing, uint16_t wp_dist"),
    /** Sticks in microseconds. */
    RC_CHANNELS(
            65,
            118,
            "uint32_t time_boot_ms, uint16_t chan1_raw, uint16_t chan2_raw, uint16_t chan3_raw, uint16_t chan4_raw,"
                    + " uint16_t chan5_raw, uint16_t chan6_raw, uint16_t chan7_raw, uint16_t chan8_raw, uint16_t chan9_raw,"
                    + " uint16_t chan10_raw, uint16_t chan11_raw, uint16_t chan12_raw, uint16_t chan13_raw,"
                    + " uint16_t chan14_raw, uint16_t chan15_raw, uint16_t chan16_raw, uint16_t chan17_raw,"
                    + " uint16_t chan18_raw, uint8_t chancount, uint8_t rssi"),
    /** Wish for a group of messages at a rate. */
    REQUEST_DATA_STREAM(
            66,
            148,
            "uint16_t req_message_rate, uint8_t target_system, uint8_t target_component, uint8_t req_stream_id,"
                    + " uint8_t start_stop"),
    /** The sticks of a joystick. */
    MANUAL_CONTROL(
            69,
            243,
            "int16_t x, int16_t y, int16_t z, int16_t r, uint16_t buttons, uint8_t target + uint16_t buttons2,"
                    + " uint8_t enabled_extensions, int16_t s, int16_t t, int16_t aux1, int16_t aux2, int16_t aux3,"
                    + " int16_t aux4, int16_t aux5, int16_t aux6"),
    /** Sticks in place of those of the radio. */
    RC_CHANNELS_OVERRIDE(
            70,
            124,
            "uint16_t chan1_raw, uint16_t chan2_raw, uint16_t chan3_raw, uint16_t chan4_raw, uint16_t chan5_raw,"
                    + " uint16_t chan6_raw, uint16_t chan7_raw, uint16_t chan8_raw, uint8_t target_system,"
                    + " uint8_t target_component + uint16_t chan9_raw, uint16_t chan10_raw, uint16_t chan11_raw,"
                    + " uint16_t chan12_raw, uint16_t chan13_raw, uint16_t chan14_raw, uint16_t chan15_raw,"
                    + " uint16_t chan16_raw, uint16_t chan17_raw, uint16_t chan18_raw"),
    /** Speed and height for a display. */
    VFR_HUD(74, 20, "float airspeed, float groundspeed, float alt, float climb, int16_t heading, uint16_t throttle"),
    /** A command with a place. */
    COMMAND_INT(
            75,
            158,
            "float param1, float param2, float param3, float param4, int32_t x, int32_t y, float z, uint16_t command,"
                    + " uint8_t target_system, uint8_t target_component, uint8_t frame, uint8_t current,"
                    + " uint8_t autocontinue"),
    /** A command with seven numbers. */
    COMMAND_LONG(
            76,
            152,
            "float param1, float param2, float param3, float param4, float param5, float param6, float param7,"
                    + " uint16_t command, uint8_t target_system, uint8_t target_component, uint8_t confirmation"),
    /** The answer to a command. */
    COMMAND_ACK(
            77,
            143,
            "uint16_t command, uint8_t result + uint8_t progress, int32_t result_param2, uint8_t target_system,"
                    + " uint8_t target_component"),
    /** Where to move. */
    SET_POSITION_TARGET_LOCAL_NED(
            84,
            143,
            "uint32_t time_boot_ms, float x, float y, float z, float vx, float vy, float vz, float afx, float afy,"
                    + " float afz, float yaw, float yaw_rate, uint16_t type_mask, uint8_t target_system,"
                    + " uint8_t target_component, uint8_t coordinate_frame"),
    /** Where the vehicle means to move. */
    POSITION_TARGET_LOCAL_NED(
            85,
            140,
            "uint32_t time_boot_ms, float x, float y, float z, float vx, float vy, float vz, float afx, float afy,"
                    + " float afz, float yaw, float yaw_rate, uint16_t type_mask, uint8_t coordinate_frame"),
    /** The place on the globe to which the vehicle means to move. */
    POSITION_TARGET_GLOBAL_INT(
            87,
            150,
            "uint32_t time_boot_ms, int32_t lat_int, int32_t lon_int, float alt, float vx, float vy, float vz, float afx,"
                    + " float afy, float afz, float yaw, float yaw_rate, uint16_t type_mask, uint8_t coordinate_frame"),
    /** Comparison of clocks. */
    TIMESYNC(111, 34, "int64_t tc1, int64_t ts1 + uint8_t target_system, uint8_t target_component"),
    /** The second inertial sensor. */
    SCALED_IMU2(
            116,
            76,
            "uint32_t time_boot_ms, int16_t xacc, int16_t yacc, int16_t zacc, int16_t xgyro, int16_t ygyro, int16_t zgyro,"
                    + " int16_t xmag, int16_t ymag, int16_t zmag + int16_t temperature"),
    /** Voltages of the board. */
    POWER_STATUS(125, 203, "uint16_t Vcc, uint16_t Vservo, uint16_t flags"),
    /** The third inertial sensor. */
    SCALED_IMU3(
            129,
            46,
            "uint32_t time_boot_ms, int16_t xacc, int16_t yacc, int16_t zacc, int16_t xgyro, int16_t ygyro, int16_t zgyro,"
                    + " int16_t xmag, int16_t ymag, int16_t zmag + int16_t temperature"),
    /** One distance. */
    DISTANCE_SENSOR(
            132,
            85,
            "uint32_t time_boot_ms, uint16_t min_distance, uint16_t max_distance, uint16_t current_distance,"
                    + " uint8_t type, uint8_t id, uint8_t orientation, uint8_t covariance + float horizontal_fov,"
                    + " float vertical_fov, float quaternion[4], uint8_t signal_quality"),
    /** The second barometer. */
    SCALED_PRESSURE2(
            137,
            195,
            "uint32_t time_boot_ms, float press_abs, float press_diff, int16_t temperature +"
                    + " int16_t temperature_press_diff"),
    /** One battery. */
    BATTERY_STATUS(
            147,
            154,
            "int32_t current_consumed, int32_t energy_consumed, int16_t temperature, uint16_t voltages[10],"
                    + " int16_t current_battery, uint8_t id, uint8_t battery_function, uint8_t type,"
                    + " int8_t battery_remaining + int32_t time_remaining, uint8_t charge_state, uint16_t voltages_ext[4],"
                    + " uint8_t mode, uint32_t fault_bitmask"),
    /** The firmware and what it can do. */
    AUTOPILOT_VERSION(
            148,
            178,
            "uint64_t capabilities, uint64_t uid, uint32_t flight_sw_version, uint32_t middleware_sw_version,"
                    + " uint32_t os_sw_version, uint32_t board_version, uint16_t vendor_id, uint16_t product_id,"
                    + " uint8_t flight_custom_version[8], uint8_t middleware_custom_version[8],"
                    + " uint8_t os_custom_version[8] + uint8_t uid2[18]"),
    /** Free memory of the board. */
    MEMINFO(152, 208, "uint16_t brkval, uint16_t freemem + uint32_t freemem32"),
    /** The state of the attitude filter. */
    AHRS(
            163,
            127,
            "float omegaIx, float omegaIy, float omegaIz, float accel_weight, float renorm_val, float error_rp,"
                    + " float error_yaw"),
    /** The state of ArduPilot's own simulation. */
    SIMSTATE(
            164,
            154,
            "float roll, float pitch, float yaw, float xacc, float yacc, float zacc, float xgyro, float ygyro, float zgyro,"
                    + " int32_t lat, int32_t lng"),
    /** One range finder, in metres. */
    RANGEFINDER(173, 83, "float distance, float voltage"),
    /** The second attitude filter. */
    AHRS2(178, 47, "float roll, float pitch, float yaw, float altitude, int32_t lat, int32_t lng"),
    /** The state of the position filter. */
    EKF_STATUS_REPORT(
            193,
            71,
            "float velocity_variance, float pos_horiz_variance, float pos_vert_variance, float compass_variance,"
                    + " float terrain_alt_variance, uint16_t flags + float airspeed_variance"),
    /** How much the board shakes. */
    VIBRATION(
            241,
            90,
            "uint64_t time_usec, float vibration_x, float vibration_y, float vibration_z, uint32_t clipping_0,"
                    + " uint32_t clipping_1, uint32_t clipping_2"),
    /** Where the vehicle returns to. */
    HOME_POSITION(
            242,
            104,
            "int32_t latitude, int32_t longitude, int32_t altitude, float x, float y, float z, float q[4],"
                    + " float approach_x, float approach_y, float approach_z + uint64_t time_usec"),
    /** Whether the vehicle flies. */
    EXTENDED_SYS_STATE(245, 130, "uint8_t vtol_state, uint8_t landed_state"),
    /** A sentence for the user. */
    STATUSTEXT(253, 83, "uint8_t severity, char text[50] + uint16_t id, uint8_t chunk_seq"),
    /** Distances all around. */
    OBSTACLE_DISTANCE(
            330,
            23,
            "uint64_t time_usec, uint16_t distances[72], uint16_t min_distance, uint16_t max_distance,"
                    + " uint8_t sensor_type, uint8_t increment + float increment_f, float angle_offset, uint8_t frame");

    private static final Map<Integer, MessageType> BY_ID = new HashMap<>();

    static {
        for (MessageType type : values()) {
            BY_ID.put(type.id, type);
        }
    }

    private final int id;
    private final int crcExtra;
    private final List<Field> fields = new ArrayList<>();
    private final Map<String, Field> byName = new HashMap<>();
    private final int baseLength;
    private final int length;

    MessageType(int id, int crcExtra, String definition) {
        this.id = id;
        this.crcExtra = crcExtra;
        String[] parts = definition.split("\\+");
        this.baseLength = addFields(parts[0], false, 0);
        this.length = parts.length == 1 ? baseLength : addFields(parts[1], true, baseLength);
    }

    private int addFields(String definitions, boolean areExtensions, int start) {
        int offset = start;
        for (String definition : definitions.split(",")) {
            Field field = Field.parse(definition, areExtensions, offset);
            fields.add(field);
            byName.put(field.name(), field);
            offset = field.end();
        }
        return offset;
    }

    /**
     * The message of a number.
     *
     * @param id as on the wire
     * @return the type; null if it is not known here
     */
    public static @Nullable MessageType of(int id) {
        return BY_ID.get(id);
    }

    /**
     * Its number.
     *
     * @return as on the wire
     */
    public int id() {
        return id;
    }

    /**
     * The byte that goes into the checksum behind the payload.
     *
     * @return 0 to 255
     */
    public int crcExtra() {
        return crcExtra;
    }

    /**
     * The length of the payload in MAVLink 1.
     *
     * @return bytes, without extension fields
     */
    public int baseLength() {
        return baseLength;
    }

    /**
     * The length of the payload before it is truncated.
     *
     * @return bytes, with extension fields
     */
    public int length() {
        return length;
    }

    List<Field> fields() {
        return fields;
    }

    Field field(String field) {
        Field found = byName.get(field);
        if (found == null) {
            throw new IllegalArgumentException(name() + " has no field " + field);
        }
        return found;
    }

    boolean has(String field) {
        return byName.containsKey(field);
    }
}
