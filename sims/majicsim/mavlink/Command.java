package majicsim.mavlink;

import majicsim.mavlink.message.Message;
import majicsim.mavlink.message.MessageType;

/**
 * A command in either form (sheet 8).
 *
 * @param number which
 * @param isInt whether it came as COMMAND_INT, whose place has integers
 * @param frame of the place; 0 if it came as COMMAND_LONG
 * @param param1 to {@code param4} its numbers
 * @param x latitude in 1e-7 degrees, or the fifth number
 * @param y longitude in 1e-7 degrees, or the sixth number
 * @param z height in m, or the seventh number
 */
record Command(
        int number,
        boolean isInt,
        int frame,
        double param1,
        double param2,
        double param3,
        double param4,
        double x,
        double y,
        double z) {
    static final int NAV_RETURN_TO_LAUNCH = 20;
    static final int NAV_LAND = 21;
    static final int NAV_TAKEOFF = 22;
    static final int DO_SET_MODE = 176;
    static final int DO_CHANGE_SPEED = 178;
    static final int DO_FLIGHTTERMINATION = 185;
    static final int DO_REPOSITION = 192;
    static final int PREFLIGHT_REBOOT = 246;
    static final int COMPONENT_ARM_DISARM = 400;
    static final int SET_MESSAGE_INTERVAL = 511;
    static final int REQUEST_MESSAGE = 512;

    static Command of(Message message) {
        boolean isInt = message.type() == MessageType.COMMAND_INT;
        return new Command(
                message.integer("command"),
                isInt,
                isInt ? message.integer("frame") : 0,
                message.number("param1"),
                message.number("param2"),
                message.number("param3"),
                message.number("param4"),
                message.number(isInt ? "x" : "param5"),
                message.number(isInt ? "y" : "param6"),
                message.number(isInt ? "z" : "param7"));
    }
}
