package majic.pioneer.arcos;

/**
 * The joystick that is plugged into the robot (ARCOS sheet 11.4). Immutable.
 *
 * @param button1 whether it is pressed
 * @param button2 whether it is pressed
 * @param x 0 to 1023, about 512 at rest
 * @param y 0 to 1023, about 512 at rest
 * @param throttle 0 to 1023
 */
public record Joystick(boolean button1, boolean button2, int x, int y, int throttle) implements Report {
    static Joystick read(FieldReader fields) {
        return new Joystick(fields.ubyte() != 0, fields.ubyte() != 0, fields.uint(), fields.uint(), fields.uint());
    }
}
