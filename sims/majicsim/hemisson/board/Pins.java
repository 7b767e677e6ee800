package majicsim.hemisson.board;

/** Pins RB0, RB6 and RB7 of the extension connector: each is an input, or an output with a latched level (sheet 15). */
public final class Pins {
    public static final int COUNT = 3;

    private final boolean[] output = new boolean[COUNT];
    private final boolean[] latched = new boolean[COUNT];
    private final boolean[] outside = new boolean[COUNT];

    public static boolean exists(int pin) {
        return pin >= 0 && pin < COUNT;
    }

    /** Command 1: the pin becomes an input and is read. */
    public boolean read(int pin) {
        output[pin] = false;
        return isHigh(pin);
    }

    /** Command 2: the pin becomes an output at that level. */
    public void write(int pin, boolean high) {
        output[pin] = true;
        latched[pin] = high;
    }

    /** Puts a level on a pin from outside; an output does not show it. */
    public void drive(int pin, boolean high) {
        outside[pin] = high;
    }

    /** The level that can be measured at the pin; an open input is low. */
    public boolean isHigh(int pin) {
        return output[pin] ? latched[pin] : outside[pin];
    }

    void reset() {
        for (int pin = 0; pin < COUNT; pin++) {
            output[pin] = false;
            latched[pin] = false;
        }
    }
}
