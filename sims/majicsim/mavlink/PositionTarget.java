package majicsim.mavlink;

import majicsim.mavlink.message.Message;

/**
 * What SET_POSITION_TARGET_LOCAL_NED asks for (sheet 7). A group of which one axis is ignored is ignored as a whole.
 *
 * @param frame 1 from the origin, 7 from here in the axes of the map, 8 and 9 in those of the vehicle
 * @param mask what is ignored
 */
record PositionTarget(
        int frame,
        int mask,
        double x,
        double y,
        double z,
        double vx,
        double vy,
        double vz,
        double yaw,
        double yawRate) {
    static final int LOCAL_NED = 1;
    static final int LOCAL_OFFSET_NED = 7;
    static final int BODY_NED = 8;
    static final int BODY_OFFSET_NED = 9;

    static final int POSITION = 0x7;
    static final int VELOCITY = 0x38;
    static final int HORIZONTAL_POSITION = 0x3;
    static final int HORIZONTAL_VELOCITY = 0x18;
    static final int ACCELERATION = 0x1C0;
    static final int YAW = 0x400;
    static final int YAW_RATE = 0x800;

    static PositionTarget of(Message message) {
        return new PositionTarget(
                message.integer("coordinate_frame"),
                message.integer("type_mask"),
                message.number("x"),
                message.number("y"),
                message.number("z"),
                message.number("vx"),
                message.number("vy"),
                message.number("vz"),
                message.number("yaw"),
                message.number("yaw_rate"));
    }

    /** A place in m from the origin, z down. */
    static PositionTarget place(double north, double east, double down) {
        return new PositionTarget(LOCAL_NED, 0xDF8, north, east, down, 0, 0, 0, 0, 0);
    }

    boolean has(int group) {
        return (mask & group) == 0;
    }

    /** Whether everything that is not ignored is a number. */
    boolean isFinite() {
        double[] values = {x, y, z, vx, vy, vz, 0, 0, 0, 0, yaw, yawRate};
        for (int bit = 0; bit < values.length; bit++) {
            if (has(1 << bit) && !Double.isFinite(values[bit])) {
                return false;
            }
        }
        return true;
    }

    boolean hasKnownFrame() {
        return frame == LOCAL_NED || frame == LOCAL_OFFSET_NED || isInBodyAxes();
    }

    boolean isInBodyAxes() {
        return frame == BODY_NED || frame == BODY_OFFSET_NED;
    }

    /** The same target in m from the origin and in the axes of the map, for a vehicle at this place. */
    PositionTarget inMap(double north, double east, double down, double heading) {
        double turn = isInBodyAxes() ? heading : 0;
        boolean isOffset = frame != LOCAL_NED;
        return new PositionTarget(
                LOCAL_NED,
                mask,
                x * Math.cos(turn) - y * Math.sin(turn) + (isOffset ? north : 0),
                x * Math.sin(turn) + y * Math.cos(turn) + (isOffset ? east : 0),
                z + (isOffset ? down : 0),
                vx * Math.cos(turn) - vy * Math.sin(turn),
                vx * Math.sin(turn) + vy * Math.cos(turn),
                vz,
                yaw + turn,
                yawRate);
    }
}
