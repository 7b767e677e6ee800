package majic.hemisson.line;

/**
 * The four lamps. The robot cannot be asked for them, so the driver keeps them (Hemisson sheet 8). Immutable.
 *
 * @param onOff the lamp that the robot's heartbeat takes back within half a second
 * @param pgm the Pgm/Exec lamp
 * @param left the front left lamp
 * @param right the front right lamp
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
