package majicsim.hemisson;

import java.util.List;
import majicsim.hemisson.board.HemissonBoard;
import majicsim.hemisson.board.Motors;
import majicsim.hemisson.board.Pins;
import majicsim.hemisson.board.RoomSensors;
import majicsim.hemisson.modules.GeneralIo;
import majicsim.hemisson.modules.Modules;
import majicsim.hemisson.options.HemissonOptions;

/**
 * Physical access to the robot: its keys, switches, inputs and outputs. Works with or without a client connected; what
 * is done to a module that is not fitted shows no effect. Every call must hold the lab's lock.
 */
public final class HemissonHandling {
    private static final int MOST_KEYS = 63;
    private static final int LCD_KEYS = 7;
    private static final int BYTE = 255;

    private final HemissonRobot robot;
    private final HemissonBoard board;
    private final Motors motors;
    private final RoomSensors sensors;
    private final Modules modules;

    HemissonHandling(HemissonRobot robot, HemissonBoard board, Motors motors, RoomSensors sensors, Modules modules) {
        this.robot = robot;
        this.board = board;
        this.motors = motors;
        this.sensors = sensors;
        this.modules = modules;
    }

    /**
     * Presses a key of a TV remote. In remote control mode keys 1 to 9 drive, 5 stops (sheet 8).
     *
     * @param key its code, 0 to 63
     * @throws IllegalArgumentException if there is no such key; nothing happened
     */
    public void pressTvKey(int key) {
        robot.pressTvKey(checked("key", key, MOST_KEYS));
    }

    /**
     * Moves the four switches on top. The robot reads them within 41 ms; its running mode changes with the next start
     * only.
     *
     * @param switches four characters 0 or 1, in the order of command I
     * @throws IllegalArgumentException if they are not; nothing happened
     */
    public void moveSwitches(String switches) {
        board.moveSwitches(HemissonOptions.standard().withSwitches(switches).switches());
    }

    /**
     * Switches it off and on: motors 0, memory cleared, receiver working again; its greeting follows 5 ms later.
     * Modules take up to 5 s more.
     */
    public void powerCycle() {
        robot.powerCycle();
    }

    /**
     * Lifts it, so that its wheels turn in the air, or puts it down.
     *
     * @param up true while it is lifted
     */
    public void lift(boolean up) {
        motors.lift(up);
    }

    /**
     * Changes the light of the room.
     *
     * @param reading what a light sensor reads far from lamps: 0 in bright sun to 255 in the dark; usually 220
     * @throws IllegalArgumentException if it is outside; nothing happened
     */
    public void lighten(int reading) {
        sensors.ambient(checked("reading", reading, BYTE));
    }

    /**
     * Its LEDs: On/Off, Pgm/Exec, front left, front right.
     *
     * @return four states
     */
    public List<Boolean> leds() {
        return List.of(board.leds[0], board.leds[1], board.leds[2], board.leds[3]);
    }

    /**
     * Whether its buzzer sounds.
     *
     * @return true while it does
     */
    public boolean isBuzzing() {
        return board.buzzer;
    }

    /**
     * Whether its receiver is blocked, until {@link #powerCycle()}.
     *
     * @return true if it receives nothing any more
     */
    public boolean isReceiverBlocked() {
        return robot.isReceiverBlocked();
    }

    /**
     * Whether what it receives are commands to it.
     *
     * @return false while its receiver is blocked, and while it takes all it receives for bytes of a program (sheet 15)
     */
    public boolean takesCommands() {
        return robot.takesCommands();
    }

    /**
     * The texts that its text-to-speech module spoke.
     *
     * @return the last 100 texts, oldest first; a stored phrase as "phrase 7"
     */
    public List<String> said() {
        return modules.voice.said();
    }

    /**
     * What its display shows.
     *
     * @return two lines of 16 characters
     */
    public List<String> shown() {
        return modules.lcd.shown();
    }

    /**
     * Presses keys of its display, or releases them.
     *
     * @param keys bits 0 to 2, one a key
     * @throws IllegalArgumentException if there are no such keys; nothing happened
     */
    public void holdLcdKeys(int keys) {
        modules.lcd.press(checked("keys", keys, LCD_KEYS));
    }

    /**
     * Puts a voltage on an analogue input of its general I/O module.
     *
     * @param channel 0 to 4
     * @param value as it is read, 0 to 255
     * @throws IllegalArgumentException if there is no such channel or value; nothing happened
     */
    public void analogueInput(int channel, int value) {
        modules.io.analogue(checked("channel", channel, GeneralIo.ANALOGUES - 1), checked("value", value, BYTE));
    }

    /**
     * Puts a level on a digital line of its general I/O module.
     *
     * @param line 0 to 11
     * @param high the level
     * @throws IllegalArgumentException if there is no such line; nothing happened
     */
    public void digitalInput(int line, boolean high) {
        modules.io.digital(checked("line", line, GeneralIo.DIGITALS - 1), high);
    }

    /**
     * The level of a digital line of its general I/O module, whether set by the firmware or from outside.
     *
     * @param line 0 to 11
     * @return true for high
     * @throws IllegalArgumentException if there is no such line
     */
    public boolean digitalLevel(int line) {
        return modules.io.isHigh(checked("line", line, GeneralIo.DIGITALS - 1));
    }

    /**
     * Puts a level on a pin of its extension connector. Shows while the pin is an input; an input that nothing drives
     * is low.
     *
     * @param pin 0 for RB0, 1 for RB6, 2 for RB7
     * @param high the level
     * @throws IllegalArgumentException if there is no such pin; nothing happened
     */
    public void pinInput(int pin, boolean high) {
        board.pins.drive(checked("pin", pin, Pins.COUNT - 1), high);
    }

    /**
     * The level of a pin of its extension connector: that of its output, or the one put on its input.
     *
     * @param pin 0 for RB0, 1 for RB6, 2 for RB7
     * @return true for high
     * @throws IllegalArgumentException if there is no such pin
     */
    public boolean pinLevel(int pin) {
        return board.pins.isHigh(checked("pin", pin, Pins.COUNT - 1));
    }

    private static int checked(String what, int value, int most) {
        if (value < 0 || value > most) {
            throw new IllegalArgumentException(what + " must be 0 to " + most + ", not " + value);
        }
        return value;
    }
}
