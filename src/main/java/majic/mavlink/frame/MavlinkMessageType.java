package majic.mavlink.frame;

import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;

/** The messages that MAJIC reads or sends, with what their frames are checked by (MAVLink sheet 6 to 8). */
public enum MavlinkMessageType {
    /** Kind of vehicle, mode, armed; once a second. */
    HEARTBEAT(0, 50, 9, 9),
    /** Voltage, current and charge. */
    SYS_STATUS(1, 124, 31, 43),
    /** Sets the mode, of autopilots before 2018. */
    SET_MODE(11, 89, 6, 6),
    /** Asks for one parameter. */
    PARAM_REQUEST_READ(20, 214, 20, 20),
    /** Asks for all parameters. */
    PARAM_REQUEST_LIST(21, 159, 2, 2),
    /** A parameter of the autopilot. */
    PARAM_VALUE(22, 220, 25, 25),
    /** Sets a parameter. */
    PARAM_SET(23, 168, 23, 23),
    /** Fix and satellites. */
    GPS_RAW_INT(24, 24, 30, 52),
    /** Roll, pitch, yaw and their rates. */
    ATTITUDE(30, 39, 28, 28),
    /** Position and velocity from the origin of the filter. */
    LOCAL_POSITION_NED(32, 185, 28, 28),
    /** Latitude, longitude, height. */
    GLOBAL_POSITION_INT(33, 104, 28, 28),
    /** Asks for a group of messages, of autopilots without 511. */
    REQUEST_DATA_STREAM(66, 148, 6, 6),
    /** Speed and climb. */
    VFR_HUD(74, 20, 20, 20),
    /** A command with a position in whole numbers. */
    COMMAND_INT(75, 158, 35, 35),
    /** A command. */
    COMMAND_LONG(76, 152, 33, 33),
    /** The answer to a command. */
    COMMAND_ACK(77, 143, 3, 10),
    /** A velocity or a position to reach. */
    SET_POSITION_TARGET_LOCAL_NED(84, 143, 53, 53),
    /** A range finder. */
    DISTANCE_SENSOR(132, 85, 14, 39),
    /** Charge and voltage of one battery. */
    BATTERY_STATUS(147, 154, 36, 54),
    /** Version and capabilities. */
    AUTOPILOT_VERSION(148, 178, 60, 78),
    /** On the ground or in the air. */
    EXTENDED_SYS_STATE(245, 130, 2, 2),
    /** A text for the user. */
    STATUSTEXT(253, 83, 51, 54),
    /** Distances all around. */
    OBSTACLE_DISTANCE(330, 23, 158, 167);

    private static final Map<Integer, MavlinkMessageType> BY_ID =
            Arrays.stream(values()).collect(Collectors.toMap(MavlinkMessageType::id, Function.identity()));

    private final int id;
    private final int crcExtra;
    private final int baseLength;
    private final int fullLength;

    MavlinkMessageType(int id, int crcExtra, int baseLength, int fullLength) {
        this.id = id;
        this.crcExtra = crcExtra;
        this.baseLength = baseLength;
        this.fullLength = fullLength;
    }

    /**
     * Finds a message.
     *
     * @param id its number
     * @return empty for one that MAJIC does not use
     */
    public static Optional<MavlinkMessageType> of(int id) {
        return Optional.ofNullable(BY_ID.get(id));
    }

    /**
     * The number of the message.
     *
     * @return 0 to 16777215
     */
    public int id() {
        return id;
    }

    /** The byte that its checksum contains besides the frame. */
    int crcExtra() {
        return crcExtra;
    }

    /** The length of its payload in MAVLink 1. */
    int baseLength() {
        return baseLength;
    }

    /**
     * The length of its payload with all extensions.
     *
     * @return bytes
     */
    public int fullLength() {
        return fullLength;
    }
}
