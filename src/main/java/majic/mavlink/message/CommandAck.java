package majic.mavlink.message;

import majic.mavlink.frame.Payload;

/**
 * A COMMAND_ACK. Immutable.
 *
 * @param command the command that is answered
 * @param result as MAV_RESULT numbers it
 */
public record CommandAck(int command, int result) {
    private static final int IN_PROGRESS = 5;

    /** Reads the fields (MAVLink sheet 6). */
    public static CommandAck of(Payload payload) {
        return new CommandAck(payload.u16(0), payload.u8(2));
    }

    /**
     * Whether an answer is for a ground station or for all: proxies forward the answers to other ground stations too.
     *
     * @param system of the ground station
     * @param component of the ground station
     */
    public static boolean isFor(Payload payload, int system, int component) {
        return isOneOf(payload.u8(8), system) && isOneOf(payload.u8(9), component);
    }

    private static boolean isOneOf(int target, int wanted) {
        return target == 0 || target == wanted;
    }

    /** Whether the command was accepted, which does not mean that it is done. */
    public boolean isAccepted() {
        return result == 0;
    }

    /** Whether another answer follows. */
    public boolean isInProgress() {
        return result == IN_PROGRESS;
    }

    /** Returns the result, for users. */
    public String title() {
        return switch (result) {
            case 0 -> "accepted";
            case 1 -> "not possible now";
            case 2 -> "denied";
            case 3 -> "unsupported";
            case 4 -> "failed";
            case IN_PROGRESS -> "in progress";
            case 6 -> "cancelled";
            default -> "result " + result;
        };
    }
}
