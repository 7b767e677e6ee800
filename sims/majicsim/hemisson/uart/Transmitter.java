package majicsim.hemisson.uart;

/** The chip's transmitter, which holds two characters: the one being sent and the next. */
final class Transmitter {
    private final double characterSeconds;
    private double lastLeft;
    private double beforeLastLeft;

    Transmitter(double characterSeconds) {
        this.characterSeconds = characterSeconds;
    }

    /** When a character that is ready at a time can be written: as soon as the one before the last was sent. */
    double place(double seconds) {
        return Math.max(seconds, beforeLastLeft);
    }

    /**
     * Writes a character at a time at which there is a place for it; returns the time at which its transmission ends.
     */
    double write(double seconds) {
        beforeLastLeft = lastLeft;
        lastLeft = Math.max(seconds, lastLeft) + characterSeconds;
        return lastLeft;
    }

    void reset(double now) {
        lastLeft = now;
        beforeLastLeft = now;
    }
}
