package majicsim.pioneer;

/**
 * What one motion channel may do, in mm and seconds or in degrees and seconds. Immutable.
 *
 * @param speed the highest speed, 0 or more
 * @param acceleration how fast speed may grow, above 0
 * @param deceleration how fast speed may fall, above 0
 */
record Limits(double speed, double acceleration, double deceleration) {
    /** With another highest speed; the sign does not matter. */
    Limits withSpeed(double newSpeed) {
        return new Limits(Math.abs(newSpeed), acceleration, deceleration);
    }

    /** As SETA and SETRA have it: above 0 an acceleration, below 0 a deceleration; 0 could never end and is ignored. */
    Limits withRamp(double ramp) {
        if (ramp == 0) {
            return this;
        }
        return ramp > 0 ? new Limits(speed, ramp, deceleration) : new Limits(speed, acceleration, -ramp);
    }

    Limits withDeceleration(double newDeceleration) {
        return new Limits(speed, acceleration, newDeceleration);
    }
}
