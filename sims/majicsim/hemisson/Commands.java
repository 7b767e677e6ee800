package majicsim.hemisson;

import java.util.Locale;
import java.util.function.IntUnaryOperator;

/**
 * The commands of HemiOS 1.50 and their replies (sheet 4.3). Nothing is parsed: each command looks at fixed positions of the buffer, so
 * odd commands get the odd replies of the real firmware.
 */
final class Commands {
    static final String EOL = "\r\n";
    static final String UNKNOWN = "Unknown Command ?!" + EOL;

    private static final String NO_REPLY = "";

    private final CommandBuffer buffer;
    private final Motors motors;
    private final InfraRed infraRed;
    private final Board board;
    private final ModuleCommands modules;
    private final FastCommands fast;
    private final Power power;

    Commands(CommandBuffer buffer, Motors motors, InfraRed infraRed, Board board, I2cBus bus, Power power) {
        this.buffer = buffer;
        this.motors = motors;
        this.infraRed = infraRed;
        this.board = board;
        this.modules = new ModuleCommands(buffer, bus);
        this.fast = new FastCommands(buffer, motors, infraRed, board, power);
        this.power = power;
    }

    /** Carries out the command in the buffer; returns the reply with its line end, or nothing where the firmware says nothing. */
    String carryOut() {
        return switch (buffer.at(0)) {
            case 'B' -> "b,HemiOS_v_1.50" + EOL;
            case 'D' -> drive();
            case 'E' -> speeds();
            case 'H' -> buzzer();
            case 'I' -> "i," + String.join(",", board.switches().split("")) + EOL;
            case 'J' -> modules.scan();
            case 'L' -> leds();
            case 'M' -> zone('m', infraRed::ambient);
            case 'N' -> all('n', infraRed::proximity);
            case 'O' -> all('o', infraRed::ambient);
            case 'P' -> zone('p', infraRed::proximity);
            case 'R' -> modules.read();
            case 'T' -> "t," + threeDigits(board.tvCode) + EOL;
            case 'W' -> modules.write();
            case 'Y' -> modules.writeMany();
            case 'Z' -> reset();
            case '1' -> pinLevel();
            case '2' -> setPin();
            case '!' -> fast.fresh();
            case '&' -> fast.read();
            case '*' -> fast.write();
            case 'S', 'X' -> giveLineAway();
            case 'Q', 'U' -> NO_REPLY;
            default -> UNKNOWN;
        };
    }

    static String threeDigits(int value) {
        return String.format(Locale.ROOT, "%03d", value);
    }

    private String drive() {
        boolean leftBack = buffer.at(2) == '-';
        int left = leftBack ? -buffer.digit(3) : buffer.digit(2);
        int second = leftBack ? 5 : 4;
        boolean rightBack = buffer.at(second) == '-';
        int right = rightBack ? -buffer.digit(second + 1) : buffer.digit(second);
        power.drive(left, right);
        return "d" + EOL;
    }

    private String speeds() {
        return String.format(Locale.ROOT, "e,%02d,%02d", motors.left(), motors.right()) + EOL;
    }

    private String buzzer() {
        board.buzzer = buffer.isOn(2);
        return "h" + EOL;
    }

    private String leds() {
        for (int i = 0; i < Board.LEDS; i++) {
            board.leds[i] = buffer.isOn(2 + 2 * i);
        }
        return "l" + EOL;
    }

    private static String all(char letter, IntUnaryOperator table) {
        return values(letter, table, 0, Eyes.COUNT);
    }

    /** Front: three from 0; rear: three from 3; ground: two from 6. An unknown zone gets no reply at all. */
    private String zone(char letter, IntUnaryOperator table) {
        return switch (buffer.at(2)) {
            case '0' -> values(letter, table, 0, 3);
            case '1' -> values(letter, table, 3, 6);
            case '2' -> values(letter, table, 6, Eyes.COUNT);
            default -> NO_REPLY;
        };
    }

    private static String values(char letter, IntUnaryOperator table, int from, int end) {
        StringBuilder reply = new StringBuilder().append(letter);
        for (int i = from; i < end; i++) {
            reply.append(',').append(threeDigits(table.applyAsInt(i)));
        }
        return reply.append(EOL).toString();
    }

    private String pinLevel() {
        int pin = buffer.digit(2);
        return "1," + (isPin(pin) ? (board.pins[pin] ? "1" : "0") + EOL : UNKNOWN);
    }

    private String setPin() {
        int pin = buffer.digit(2);
        if (!isPin(pin)) {
            return "2" + EOL + UNKNOWN;
        }
        board.pins[pin] = buffer.isOn(4);
        return "2" + EOL;
    }

    private static boolean isPin(int pin) {
        return pin >= 0 && pin < Board.PINS;
    }

    private String reset() {
        power.reset();
        return "z" + EOL;
    }

    private String giveLineAway() {
        power.deafen();
        return NO_REPLY;
    }
}
