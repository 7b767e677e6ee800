package majic.hemisson.line;

/**
 * The four LEDs. The robot does not report them, so the driver keeps their state (Hemisson sheet 8). Immutable.
 *
 * @param onOff the On/Off LED, which the robot's heartbeat sets back within half a second
 * @param pgm the Pgm/Exec LED
 * @param left the front left LED
 * @param right the front right LED
 */
public record Leds(boolean onOff, boolean pgm, boolean left, boolean right) {
    public static final Leds OFF = new Leds(false, false, false, false);

    public Leds withOnOff(boolean on) {
        return new Leds(on, pgm, left, right);
    }

    public Leds withPgm(boolean on) {
        return new Leds(onOff, on, left, right);
    }

    public Leds withLeft(boolean on) {
        return new Leds(onOff, pgm, on, right);
    }

    public Leds withRight(boolean on) {
        return new Leds(onOff, pgm, left, on);
    }
}
