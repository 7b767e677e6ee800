package majicsim.hemisson.firmware;

import majicsim.hemisson.board.HemissonBoard;
import majicsim.hemisson.board.Motors;
import majicsim.hemisson.board.SensorTables;
import majicsim.hemisson.uart.Reply;

/**
 * The commands {@code Q}, {@code S}, {@code U} and {@code X}, by which K-Team's BotStudio loads, starts and watches a
 * program. Their answers have no line end, and {@code S} and {@code U} take the bytes behind their CR raw (sheet 15).
 * The program memory is erased: a program started there sets the right motor to 63.
 */
public final class BotStudio {
    private static final int ADDRESS_BYTES = 2;
    private static final int FIRST_PAGE = 0x18;
    private static final int LAST_PAGE = 0x1A;
    private static final int NO_PROGRAM = 0xFF;

    /** An erased word, 3FFF, as the firmware takes it for a speed: its high byte. */
    private static final int ERASED_SPEED = 0x3F;

    private final Motors motors;
    private final HemissonBoard board;
    private final SensorTables tables;
    private final int[] end = {NO_PROGRAM, NO_PROGRAM};
    private char command;
    private int addressBytes;
    private int programBytes;

    public BotStudio(Motors motors, HemissonBoard board, SensorTables tables) {
        this.motors = motors;
        this.board = board;
        this.tables = tables;
    }

    /** Where the program ends, proximity and light in the order of the memory, program state, level of RB0. */
    Reply status() {
        StringBuilder reply = new StringBuilder("q");
        reply.append(byteOf(end[0] - FIRST_PAGE)).append(byteOf(end[1]));
        reply.append(tables.tables());
        return Reply.of(reply.append(byteOf(0))
                .append(board.pins.isHigh(0) ? '\1' : '\0')
                .toString());
    }

    /** Command S or U: the next bytes are no commands. */
    Reply begin(char letter) {
        command = letter;
        addressBytes = ADDRESS_BYTES;
        programBytes = 0;
        return Reply.NONE;
    }

    /** Command X: the program ends. */
    Reply end() {
        forget();
        motors.set(0, 0);
        board.leds[HemissonBoard.FRONT_LEFT] = false;
        board.leds[HemissonBoard.FRONT_RIGHT] = false;
        board.buzzer = false;
        return Reply.of("x");
    }

    public boolean isTakingBytes() {
        return addressBytes > 0 || programBytes > 0;
    }

    /** Takes the next byte that S or U waits for. */
    public Reply take(char c) {
        return addressBytes > 0 ? takeAddress(c) : takeProgram(c);
    }

    public void reset() {
        addressBytes = 0;
        programBytes = 0;
        forget();
    }

    private Reply takeAddress(char c) {
        end[ADDRESS_BYTES - addressBytes] = addressBytes == ADDRESS_BYTES ? c + FIRST_PAGE & 0xFF : c;
        addressBytes--;
        if (addressBytes > 0) {
            return Reply.NONE;
        }
        if (command == 'S') {
            motors.set(motors.left(), ERASED_SPEED);
            return Reply.of("s");
        }
        programBytes =
                1 + (end[0] > LAST_PAGE ? (LAST_PAGE - FIRST_PAGE) * 256 + 255 : (end[0] - FIRST_PAGE) * 256 + end[1]);
        return programBytes > 0 ? Reply.NONE : loaded("");
    }

    private Reply takeProgram(char c) {
        programBytes--;
        return programBytes > 0 ? Reply.of(String.valueOf(c)) : loaded(String.valueOf(c));
    }

    private Reply loaded(String echo) {
        programBytes = 0;
        forget();
        return Reply.of(echo + "u");
    }

    private void forget() {
        end[0] = NO_PROGRAM;
        end[1] = NO_PROGRAM;
    }

    private static char byteOf(int value) {
        return (char) (value & 0xFF);
    }
}
