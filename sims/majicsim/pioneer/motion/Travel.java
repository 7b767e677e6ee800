package majicsim.pioneer.motion;

/**
 * Where one motion channel is and how fast it goes, in mm or in degrees. Immutable.
 *
 * @param position how far it came since the robot was switched on
 * @param speed signed, a second
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
