package majic.ros.readings;

import java.util.Locale;

/** What it means for a distance that beams have no echo. */
public enum NoEcho {
    /**
     * Clear if nothing can hide in front of the scanner: if what is too near for it would touch the robot. Otherwise
     * unknown.
     */
    AUTO,
    /** Always unknown. */
    UNKNOWN,
    /** Always clear. */
    CLEAR;

    /**
     * Returns the word for users.
     *
     * @return its name in lower case
     */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }
}
