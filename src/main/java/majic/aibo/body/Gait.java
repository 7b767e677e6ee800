package majic.aibo.body;

import java.util.Arrays;

/** The four gaits of the stick; each runs for a given time, ms (URBI sheet 15). */
public enum Gait {
    /** Straight ahead. */
    FORWARD("walk", 1, "forward", 12.0),
    /** Straight back. */
    BACKWARD("walk", -1, "backward", 12.0),
    /** Counterclockwise on the spot. */
    LEFT("turn", 1, "left", 27.8),
    /** Clockwise on the spot. */
    RIGHT("turn", -1, "right", 27.8);

    private final String function;
    private final int sign;
    private final String key;
    private final double usualMsPerUnit;

    Gait(String function, int sign, String key, double usualMsPerUnit) {
        this.function = function;
        this.sign = sign;
        this.key = key;
        this.usualMsPerUnit = usualMsPerUnit;
    }

    /** The gait that covers a signed distance. */
    public static Gait walking(double mm) {
        return mm < 0 ? BACKWARD : FORWARD;
    }

    /** The gait that covers a signed angle. */
    public static Gait turning(double degrees) {
        return degrees < 0 ? RIGHT : LEFT;
    }

    /** The gait with a name. */
    public static Gait of(String key) {
        return Arrays.stream(values())
                .filter(gait -> gait.key.equals(key))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("no gait: " + key));
    }

    public boolean isWalk() {
        return this == FORWARD || this == BACKWARD;
    }

    int sign() {
        return sign;
    }

    /** How it is called in the settings and in messages. */
    public String key() {
        return key;
    }

    /**
     * Milliseconds for one mm or one degree at the usual pace of the legs, without a calibration (URBI sheet 15,
     * "Calibration").
     */
    double usualMsPerUnit() {
        return usualMsPerUnit;
    }

    /** The variable on the dog with the duration of a cycle of the legs, ms; two gaits share it. */
    String paceVariable() {
        return "robot." + function + "speed";
    }

    /** The call that makes the dog do it. */
    String call(long ms) {
        return "robot." + function + "(" + sign * ms + ")";
    }

    /** The message for an error that the dog reports for a call. */
    public static String refusal(String failure) {
        return failure.contains("function") || failure.contains("robot.")
                ? "the stick in the dog has no such gait (" + failure + ")"
                : "the dog refuses: " + failure;
    }
}
