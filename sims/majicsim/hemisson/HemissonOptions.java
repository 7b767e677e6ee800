package majicsim.hemisson;

/**
 * How true to its weaknesses the robot is.
 *
 * @param overrun whether a third character that arrives while it answers deafens it until it is powered off and on (sheet 4.4);
 *     otherwise it is lenient, as behind a serial server that
 *     buffers; includes paced
 * @param paced whether replies take 88 µs a character, as far as the lab's step shows it; otherwise they come at once
 * @param modules whether a linear camera (C0) and an ultrasonic sensor (E0) sit on its bus
 * @param switches the four top switches in the order of command I, each 0 or 1
 */
public record HemissonOptions(boolean overrun, boolean paced, boolean modules, String switches) {
    /** All switches for remote control (sheet 7). */
    public static final String REMOTE_CONTROL = "1111";

    /**
     * Checks the switches.
     *
     * @throws IllegalArgumentException if they are not four characters 0 or 1
     */
    public HemissonOptions {
        if (!switches.matches("[01]{4}")) {
            throw new IllegalArgumentException("switches must be four characters 0 or 1, not '" + switches + "'");
        }
    }

    /**
     * A forgiving robot without modules, switched to remote control.
     *
     * @return the options
     */
    public static HemissonOptions standard() {
        return new HemissonOptions(false, false, false, REMOTE_CONTROL);
    }
}
