package majicsim.hemisson.options;

import java.util.Set;
import majicsim.hemisson.modules.ModuleKind;

/**
 * The kind of a simulated Hemisson, and which weaknesses of the real one it has. Immutable.
 *
 * @param dialect the maker's version of its firmware
 * @param modules the modules on its bus
 * @param switches the four top switches in the order of command I, each 0 or 1; they choose the running mode (sheet 7)
 * @param isPaced whether characters take 88 µs each, both ways; otherwise replies come at once
 * @param hasOverrun whether a third character that waits while it is busy blocks the receiver until it is powered off
 *     and on (sheet 4.4); otherwise it is lenient, as behind a serial server that buffers. Characters take their time
 *     then too
 * @param ambient what a light sensor reads far from lamps, 0 bright sun to 255 dark
 * @param mismatchPercent by how much the right wheel is faster than the left one, -50 to 50, beside what the noise does
 */
public record HemissonOptions(
        Dialect dialect,
        Set<ModuleKind> modules,
        String switches,
        boolean isPaced,
        boolean hasOverrun,
        int ambient,
        double mismatchPercent) {
    /** All switches for remote control (sheet 7). */
    public static final String REMOTE_CONTROL = "1111";

    static final int USUAL_AMBIENT = 220;
    private static final double MOST_MISMATCH_PERCENT = 50;

    /**
     * Checks them.
     *
     * @throws IllegalArgumentException if something is outside its range; the message names it
     */
    public HemissonOptions {
        modules = Set.copyOf(modules);
        if (!switches.matches("[01]{4}")) {
            throw new IllegalArgumentException("switches must be four characters 0 or 1, not '" + switches + "'");
        }
        if (ambient < 0 || ambient > 255) {
            throw new IllegalArgumentException("ambient must be 0 (bright) to 255 (dark), not " + ambient);
        }
        if (!(Math.abs(mismatchPercent) <= MOST_MISMATCH_PERCENT)) {
            throw new IllegalArgumentException("mismatch must be -50 to 50 percent, not " + mismatchPercent);
        }
    }

    /**
     * A K-Team robot without modules and without weaknesses, switched to remote control, that answers at once.
     *
     * @return the options
     */
    public static HemissonOptions standard() {
        return new HemissonOptions(Dialect.KTEAM, Set.of(), REMOTE_CONTROL, false, false, USUAL_AMBIENT, 0);
    }

    /**
     * Parses a model: a dialect, then the differences of this robot behind plus signs, in any case.
     *
     * @param model such as {@code kteam+camera+ultrasonic+overrun} or {@code roadnarrows+switches=1110+ambient=60}
     * @return the options
     * @throws IllegalArgumentException if there is no such robot; the message names the wrong word and the right ones
     */
    public static HemissonOptions parse(String model) {
        return ModelParser.parse(model);
    }

    /**
     * The same robot with its switches set.
     *
     * @param newSwitches four characters 0 or 1
     * @return the options
     * @throws IllegalArgumentException if they are not
     */
    public HemissonOptions withSwitches(String newSwitches) {
        return new HemissonOptions(dialect, modules, newSwitches, isPaced, hasOverrun, ambient, mismatchPercent);
    }

    /**
     * The same robot with modules.
     *
     * @param newModules all modules on its bus
     * @return the options
     */
    public HemissonOptions withModules(Set<ModuleKind> newModules) {
        return new HemissonOptions(dialect, newModules, switches, isPaced, hasOverrun, ambient, mismatchPercent);
    }

    /**
     * The same robot with another firmware.
     *
     * @param newDialect the maker's version
     * @return the options
     */
    public HemissonOptions withDialect(Dialect newDialect) {
        return new HemissonOptions(newDialect, modules, switches, isPaced, hasOverrun, ambient, mismatchPercent);
    }

    /**
     * The same robot at the speed of its line.
     *
     * @return the options
     */
    public HemissonOptions paced() {
        return new HemissonOptions(dialect, modules, switches, true, hasOverrun, ambient, mismatchPercent);
    }

    /**
     * The same robot with its true receiver, which a third waiting character blocks.
     *
     * @return the options
     */
    public HemissonOptions withOverrun() {
        return new HemissonOptions(dialect, modules, switches, isPaced, true, ambient, mismatchPercent);
    }

    /**
     * The same robot in other light.
     *
     * @param newAmbient what a light sensor reads far from lamps, 0 to 255
     * @return the options
     * @throws IllegalArgumentException if it is outside
     */
    public HemissonOptions withAmbient(int newAmbient) {
        return new HemissonOptions(dialect, modules, switches, isPaced, hasOverrun, newAmbient, mismatchPercent);
    }

    /**
     * The same robot with unequal wheels.
     *
     * @param percent by how much the right one is faster, -50 to 50
     * @return the options
     * @throws IllegalArgumentException if it is outside
     */
    public HemissonOptions withMismatch(double percent) {
        return new HemissonOptions(dialect, modules, switches, isPaced, hasOverrun, ambient, percent);
    }
}
