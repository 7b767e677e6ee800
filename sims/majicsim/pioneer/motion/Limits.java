package majicsim.pioneer.motion;

/**
 * The limits of one motion channel, in mm and seconds or in degrees and seconds. Immutable.
 *
 * @param forward the highest speed ahead or counterclockwise, 0 or more
 * @param backward the highest speed the other way, 0 or more
 * @param acceleration how fast speed may grow, above 0
 * @param deceleration how fast speed may fall, above 0
 */
public record Limits(double forward, double backward, double acceleration, double deceleration) {
    /** The same highest speed either way. */
    public Limits(double speed, double acceleration, double deceleration) {
        this(speed, speed, acceleration, deceleration);
    }

    /** The highest speed either way. */
    public double speed() {
        return Math.max(forward, backward);
    }

    /** The highest speed in the direction that this number's sign has. */
    double speedTowards(double direction) {
        return direction < 0 ? backward : forward;
    }

    /** With another highest speed either way; the sign does not matter. */
    public Limits withSpeed(double newSpeed) {
        return new Limits(Math.abs(newSpeed), acceleration, deceleration);
    }

    /** As SETRVDIR has it: another highest speed in the direction of its sign alone. */
    public Limits withSpeedTowards(double newSpeed) {
        return newSpeed < 0
                ? new Limits(forward, -newSpeed, acceleration, deceleration)
                : new Limits(newSpeed, backward, acceleration, deceleration);
    }

    /** As SETA and SETRA have it: above 0 an acceleration, below 0 a deceleration; 0 is ignored. */
    public Limits withRamp(double ramp) {
        if (ramp == 0) {
            return this;
        }
        return ramp > 0
                ? new Limits(forward, backward, ramp, deceleration)
                : new Limits(forward, backward, acceleration, -ramp);
    }

    Limits withDeceleration(double newDeceleration) {
        return new Limits(forward, backward, acceleration, newDeceleration);
    }

    /** No more than the tops in anything. */
    Limits cappedBy(Limits tops) {
        return new Limits(
                Math.min(forward, tops.forward),
                Math.min(backward, tops.backward),
                Math.min(acceleration, tops.acceleration),
                Math.min(deceleration, tops.deceleration));
    }
}
