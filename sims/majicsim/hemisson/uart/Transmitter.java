package majicsim.hemisson.uart;

/** The chip's transmitter holds two characters: the one that is leaving and the next. */
final class Transmitter {
    private final double characterSeconds;
    private double lastLeft;
    private double beforeLastLeft;

    Transmitter(double characterSeconds) {
        this.characterSeconds = characterSeconds;
    }

    /** When a character can be written that is ready at a time: as soon as the one before the last has left. */
    double place(double seconds) {
        return Math.max(seconds, beforeLastLeft);
    }

    /** Writes a character at a time at which there is a place for it; returns when it has left. */
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
