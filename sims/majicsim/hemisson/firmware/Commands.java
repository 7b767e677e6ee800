package majicsim.hemisson.firmware;

import java.util.Locale;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;
import majicsim.hemisson.board.CommandBuffer;
import majicsim.hemisson.board.HemissonBoard;
import majicsim.hemisson.board.InfraRedSensors;
import majicsim.hemisson.board.Motors;
import majicsim.hemisson.board.Pins;
import majicsim.hemisson.board.RobotControl;
import majicsim.hemisson.board.SensorTables;
import majicsim.hemisson.modules.I2cBus;
import majicsim.hemisson.uart.Reply;

/**
 * The commands of HemiOS 1.50 and their replies (sheet 4.3). Nothing is parsed: each command looks at fixed positions
 * of the buffer, so odd commands get the odd replies of the real firmware.
 */
public final class Commands implements Interpreter {
    static final String GREETING_END = " , K-Team S.A. ( Alexandre Colot )  30-Aug-04 @ 09:37:30" + Reply.EOL
            + "E-Mail : info@hemisson.com" + Reply.EOL + Reply.EOL;
    private static final String GREETING = "HemiOS V1.50" + GREETING_END;
    private static final String UNKNOWN = "Unknown Command ?!";

    /** The numbers that replies usually contain, since each reply of sensors has many of them. */
    private static final String[] THREE_DIGITS =
            IntStream.range(0, 1000).mapToObj(Commands::formatted).toArray(String[]::new);

    /** The time of command D without the interrupt (sheet 15: 0.31 ms to the end of its answer). */
    private static final double SPEEDS_SECONDS = 22e-6;

    private final CommandBuffer buffer;
    private final Motors motors;
    private final SensorTables tables;
    private final HemissonBoard board;
    private final ModuleCommands modules;
    private final FastCommands fast;
    private final BotStudio botStudio;
    private final RobotControl control;

    public Commands(
            CommandBuffer buffer,
            Motors motors,
            SensorTables tables,
            HemissonBoard board,
            I2cBus bus,
            BotStudio botStudio,
            RobotControl control) {
        this.buffer = buffer;
        this.motors = motors;
        this.tables = tables;
        this.board = board;
        this.modules = new ModuleCommands(buffer, bus);
        this.fast = new FastCommands(buffer, motors, tables, board, control);
        this.botStudio = botStudio;
        this.control = control;
    }

    @Override
    public String greeting() {
        return GREETING;
    }

    @Override
    public Reply carryOut() {
        return switch (buffer.at(0)) {
            case 'B' -> Reply.line("b,HemiOS_v_1.50");
            case 'D' -> drive();
            case 'E' -> speeds();
            case 'H' -> buzzer();
            case 'I' -> Reply.line("i," + String.join(",", board.switches().split("")));
            case 'J' -> modules.scan();
            case 'L' -> leds();
            case 'M' -> zone('m', tables::ambient);
            case 'N' -> all('n', tables::proximity);
            case 'O' -> all('o', tables::ambient);
            case 'P' -> zone('p', tables::proximity);
            case 'R' -> modules.read();
            case 'T' -> Reply.line("t," + threeDigits(board.tvCode));
            case 'W' -> modules.write();
            case 'Y' -> modules.writeMany();
            case 'Z' -> reset();
            case '1' -> pinLevel();
            case '2' -> setPin();
            case '!' -> fast.fresh();
            case '&' -> fast.read();
            case '*' -> fast.write();
            case 'Q' -> botStudio.status();
            case 'S', 'U' -> botStudio.begin(buffer.at(0));
            case 'X' -> botStudio.end();
            default -> Reply.line(UNKNOWN);
        };
    }

    static String threeDigits(int value) {
        return value >= 0 && value < THREE_DIGITS.length ? THREE_DIGITS[value] : formatted(value);
    }

    private static String formatted(int value) {
        return String.format(Locale.ROOT, "%03d", value);
    }

    private Reply drive() {
        boolean leftBack = buffer.at(2) == '-';
        int left = leftBack ? -buffer.digit(3) : buffer.digit(2);
        int second = leftBack ? 5 : 4;
        boolean rightBack = buffer.at(second) == '-';
        int right = rightBack ? -buffer.digit(second + 1) : buffer.digit(second);
        control.drive(left, right);
        return Reply.line("d").thinking(SPEEDS_SECONDS);
    }

    private Reply speeds() {
        return Reply.line(String.format(Locale.ROOT, "e,%02d,%02d", motors.left(), motors.right()));
    }

    private Reply buzzer() {
        board.buzzer = buffer.isOn(2);
        return Reply.line("h");
    }

    private Reply leds() {
        for (int i = 0; i < HemissonBoard.LEDS; i++) {
            board.leds[i] = buffer.isOn(2 + 2 * i);
        }
        return Reply.line("l");
    }

    private static Reply all(char letter, IntUnaryOperator table) {
        return values(letter, table, 0, InfraRedSensors.COUNT);
    }

    /** Front: three from 0; rear: three from 3; ground: two from 6. An unknown zone gets no reply at all. */
    private Reply zone(char letter, IntUnaryOperator table) {
        return switch (buffer.at(2)) {
            case '0' -> values(letter, table, 0, 3);
            case '1' -> values(letter, table, 3, 6);
            case '2' -> values(letter, table, 6, InfraRedSensors.COUNT);
            default -> Reply.NONE;
        };
    }

    private static Reply values(char letter, IntUnaryOperator table, int from, int end) {
        StringBuilder reply = new StringBuilder().append(letter);
        for (int i = from; i < end; i++) {
            reply.append(',').append(threeDigits(table.applyAsInt(i)));
        }
        return Reply.line(reply.toString());
    }

    private Reply pinLevel() {
        int pin = buffer.digit(2);
        return Reply.line("1," + (Pins.exists(pin) ? board.pins.read(pin) ? "1" : "0" : UNKNOWN));
    }

    private Reply setPin() {
        int pin = buffer.digit(2);
        if (!Pins.exists(pin)) {
            return Reply.line("2" + Reply.EOL + UNKNOWN);
        }
        board.pins.write(pin, buffer.isOn(4));
        return Reply.line("2");
    }

    private Reply reset() {
        control.reset();
        return Reply.line("z");
    }
}
