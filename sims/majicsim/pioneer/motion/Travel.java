package majicsim.pioneer.motion;

/**
 * The position and speed of one motion channel, in mm or in degrees. Immutable.
 *
 * @param position the motion since the robot was switched on
 * @param speed per second, signed
 */
record Travel(double position, double speed) {
    static final Travel REST = new Travel(0, 0);

    Travel after(double seconds, double acceleration) {
        return new Travel(
                position + speed * seconds + acceleration * seconds * seconds / 2, speed + acceleration * seconds);
    }

    Travel withSpeed(double newSpeed) {
        return new Travel(position, newSpeed);
    }
}
