package majic.hemisson.parameters;

import org.jspecify.annotations.Nullable;

/**
 * The pins of the extension connector that were set. Reading a pin makes it an input again (Hemisson sheet 15), so the
 * level set last is kept here and such a pin is not read. Thread-safe.
 */
public final class Pins {
    private static final int PINS = 3;

    private final @Nullable Integer[] outputs = new Integer[PINS];

    /** The level that a pin was set to; null while it is an input. */
    synchronized @Nullable Integer output(int pin) {
        return outputs[pin];
    }

    /** Records the level that a pin is set to from now on; null for an input. */
    synchronized void becomes(int pin, @Nullable Integer level) {
        outputs[pin] = level;
    }

    /** Sets all to inputs, after a reset of the robot. */
    public synchronized void forget() {
        for (int pin = 0; pin < PINS; pin++) {
            outputs[pin] = null;
        }
    }
}
