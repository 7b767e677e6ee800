package majic.mavlink.message;

import majic.mavlink.frame.MavlinkMessageType;
import majic.mavlink.frame.OutgoingMessage;

/** Makes the messages that MAJIC sends (MAVLink sheet 3, 5, 7 and 8). All are for the autopilot of a system. */
public final class MavlinkRequests {
    /** The command that sets the mode. */
    public static final int SET_MODE = 176;

    /** The command that arms and disarms. */
    public static final int ARM = 400;

    /** The command that lets an aircraft take off. */
    public static final int TAKE_OFF = 22;

    /** The command that sets how often a message comes. */
    public static final int SET_INTERVAL = 511;

    /** The command that asks for a message once. */
    public static final int REQUEST_MESSAGE = 512;

    /** The command that sends a vehicle to a place on the earth. */
    public static final int REPOSITION = 192;

    private static final int AUTOPILOT = 1;
    private static final int GROUND_STATION = 6;
    private static final int NO_AUTOPILOT = 8;
    private static final int ACTIVE = 4;
    private static final int PROTOCOL = 3;

    /** Frame 8: axes of the vehicle; every bit of a mask means that a field is ignored. */
    private static final int BODY_AXES = 8;

    private static final int VELOCITY_AND_YAW_RATE = 0x05E7;
    private static final int YAW_RATE = 0x05FF;
    private static final int FLIGHT = 0x05C7;

    private static final int RELATIVE_HEIGHT = 6;
    private static final int FULL_INTERVAL_US = 1_000_000;

    private MavlinkRequests() {}

    /** The heartbeat of a ground station. */
    public static OutgoingMessage heartbeat() {
        return new OutgoingMessage(MavlinkMessageType.HEARTBEAT)
                .i32(0)
                .u8(GROUND_STATION, NO_AUTOPILOT, 0, ACTIVE, PROTOCOL);
    }

    /**
     * A command.
     *
     * @param confirmation how often it was sent before
     * @param parameters up to seven
     */
    public static OutgoingMessage command(int system, int command, int confirmation, double... parameters) {
        OutgoingMessage message = new OutgoingMessage(MavlinkMessageType.COMMAND_LONG).f32(parameters);
        for (int left = parameters.length; left < 7; left++) {
            message.f32(0);
        }
        return message.u16(command).u8(system, AUTOPILOT, confirmation);
    }

    /**
     * A velocity to be followed for at most 3 s. On the spot the velocity is left out, since the direction of one would
     * be a heading.
     *
     * @param mmPerSec ahead positive
     * @param degPerSec to the left positive
     */
    public static OutgoingMessage velocity(int system, double mmPerSec, double degPerSec) {
        boolean onTheSpot = mmPerSec == 0 && degPerSec != 0;
        return new OutgoingMessage(MavlinkMessageType.SET_POSITION_TARGET_LOCAL_NED)
                .i32(0)
                .f32(0, 0, 0)
                .f32(mmPerSec / 1000, 0, 0)
                .f32(0, 0, 0)
                .f32(0, 0.0 - Math.toRadians(degPerSec))
                .u16(onTheSpot ? YAW_RATE : VELOCITY_AND_YAW_RATE)
                .u8(system, AUTOPILOT, BODY_AXES);
    }

    /**
     * A velocity of a copter, to be followed for at most 3 s.
     *
     * @param mmPerSec ahead positive
     * @param degPerSec to the left positive
     * @param climbMmPerSec up positive
     */
    public static OutgoingMessage flight(int system, double mmPerSec, double degPerSec, double climbMmPerSec) {
        return new OutgoingMessage(MavlinkMessageType.SET_POSITION_TARGET_LOCAL_NED)
                .i32(0)
                .f32(0, 0, 0)
                .f32(mmPerSec / 1000, 0, 0.0 - climbMmPerSec / 1000)
                .f32(0, 0, 0)
                .f32(0, 0.0 - Math.toRadians(degPerSec))
                .u16(FLIGHT)
                .u8(system, AUTOPILOT, BODY_AXES);
    }

    /**
     * Sends a vehicle to a place by its own navigation.
     *
     * @param latitudeE7 1e-7 degrees
     * @param longitudeE7 1e-7 degrees
     */
    public static OutgoingMessage reposition(int system, int latitudeE7, int longitudeE7) {
        return new OutgoingMessage(MavlinkMessageType.COMMAND_INT)
                .f32(-1, 1, 0, 0)
                .i32(latitudeE7)
                .i32(longitudeE7)
                .f32(0)
                .u16(REPOSITION)
                .u8(system, AUTOPILOT, RELATIVE_HEIGHT, 0, 0);
    }

    /** Asks for all parameters. */
    public static OutgoingMessage listParameters(int system) {
        return new OutgoingMessage(MavlinkMessageType.PARAM_REQUEST_LIST).u8(system, AUTOPILOT);
    }

    /** Asks for a parameter by its place in the list. */
    public static OutgoingMessage readParameter(int system, int index) {
        return new OutgoingMessage(MavlinkMessageType.PARAM_REQUEST_READ)
                .u16(index)
                .u8(system, AUTOPILOT)
                .text("", ParameterValue.LONGEST_NAME);
    }

    /** Asks for a parameter. */
    public static OutgoingMessage readParameter(int system, String name) {
        return new OutgoingMessage(MavlinkMessageType.PARAM_REQUEST_READ)
                .u16(-1)
                .u8(system, AUTOPILOT)
                .text(name, ParameterValue.LONGEST_NAME);
    }

    /**
     * Sets a parameter.
     *
     * @param bits the four bytes of the value: whole numbers of PX4 are none with a point
     * @param type as its PARAM_VALUE has it
     */
    public static OutgoingMessage setParameter(int system, String name, int bits, int type) {
        return new OutgoingMessage(MavlinkMessageType.PARAM_SET)
                .i32(bits)
                .u8(system, AUTOPILOT)
                .text(name, ParameterValue.LONGEST_NAME)
                .u8(type);
    }

    /**
     * Asks for a message again and again.
     *
     * @param hz how often a second
     */
    public static OutgoingMessage interval(int system, MavlinkMessageType message, int hz) {
        return command(system, SET_INTERVAL, 0, message.id(), FULL_INTERVAL_US / (double) hz);
    }

    /**
     * Asks an autopilot that has no {@link #interval} for a group of messages.
     *
     * @param stream the group
     * @param hz how often a second
     */
    public static OutgoingMessage stream(int system, int stream, int hz) {
        return new OutgoingMessage(MavlinkMessageType.REQUEST_DATA_STREAM)
                .u16(hz)
                .u8(system, AUTOPILOT, stream, 1);
    }
}
