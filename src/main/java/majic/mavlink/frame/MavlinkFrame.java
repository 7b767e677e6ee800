package majic.mavlink.frame;

/**
 * One frame that has arrived whole. Immutable.
 *
 * @param version 1 or 2, of the protocol
 * @param sequence 0 to 255, counted by its sender
 * @param system the vehicle, 0 to 255
 * @param component the part of the vehicle, 1 for its autopilot
 * @param type the message
 * @param payload its fields
 */
public record MavlinkFrame(
        int version, int sequence, int system, int component, MavlinkMessageType type, Payload payload) {
    /** The component of the autopilot. */
    public static final int AUTOPILOT = 1;

    /**
     * Returns whether the autopilot of a vehicle sent it.
     *
     * @return false for cameras, gimbals and other computers on a vehicle
     */
    public boolean isOfAutopilot() {
        return component == AUTOPILOT;
    }
}
