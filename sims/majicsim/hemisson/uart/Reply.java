package majicsim.hemisson.uart;

/**
 * An answer of the firmware with its durations. Times are those of a line at its true speed; without pacing only
 * measuring takes time.
 *
 * @param text all of it, in Latin-1; empty for no reply at all
 * @param thinkingSeconds from taking the command to writing the first character
 * @param scanningSeconds between the first character and the others
 * @param measuringSeconds before the first character, paced or not
 */
public record Reply(String text, double thinkingSeconds, double scanningSeconds, double measuringSeconds) {
    public static final String EOL = "\r\n";
    public static final Reply NONE = of("");

    public static Reply of(String text) {
        return new Reply(text, 0, 0, 0);
    }

    /** A reply of one line. */
    public static Reply line(String text) {
        return of(text + EOL);
    }

    public Reply thinking(double seconds) {
        return new Reply(text, seconds, scanningSeconds, measuringSeconds);
    }

    public Reply scanning(double seconds) {
        return new Reply(text, thinkingSeconds, seconds, measuringSeconds);
    }

    public Reply measuring(double seconds) {
        return new Reply(text, thinkingSeconds, scanningSeconds, seconds);
    }
}
