package majic.hemisson;

/**
 * The four lamps. The robot cannot be asked for them, so the driver keeps them (Hemisson sheet 8). Immutable.
 *
 * @param onOff the lamp that the robot's heartbeat takes back within half a second
 * @param pgm the Pgm/Exec lamp
 * @param left the front left lamp
 * @param right the front right lamp
 */
record Leds(boolean onOff, boolean pgm, boolean left, boolean right) {
    static final Leds OFF = new Leds(false, false, false, false);

    Leds withOnOff(boolean on) {
        return new Leds(on, pgm, left, right);
    }

    Leds withPgm(boolean on) {
        return new Leds(onOff, on, left, right);
    }

    Leds withLeft(boolean on) {
        return new Leds(onOff, pgm, on, right);
    }

    Leds withRight(boolean on) {
        return new Leds(onOff, pgm, left, on);
    }
}
