package majicsim.mavlink;

/**
 * How a vehicle truly moves.
 *
 * @param north m from the middle of the room
 * @param east m from the middle of the room
 * @param height m above the floor
 * @param northSpeed m/s
 * @param eastSpeed m/s
 * @param climb m/s, up positive
 * @param roll rad, right side down positive
 * @param pitch rad, nose up positive
 * @param yaw rad clockwise from north, -π to π
 * @param yawRate rad/s clockwise
 */
record Motion(
        double north,
        double east,
        double height,
        double northSpeed,
        double eastSpeed,
        double climb,
        double roll,
        double pitch,
        double yaw,
        double yawRate) {

    double groundSpeed() {
        return Math.hypot(northSpeed, eastSpeed);
    }

    /** The same direction as an angle from -π to π. */
    static double wrapped(double radians) {
        return Math.IEEEremainder(radians, 2 * Math.PI);
    }

    /** The yaw of a heading in the room. */
    static double yawOf(double headingDeg) {
        return wrapped(Math.toRadians(90 - headingDeg));
    }
}
