package majicsim.hemisson.firmware;

import majicsim.hemisson.modules.I2cBus;
import majicsim.hemisson.modules.ModuleKind;
import majicsim.hemisson.modules.Ultrasonic;
import majicsim.hemisson.uart.Reply;

/** The ultrasonic sensor's commands in the RoadNarrows dialect: {@code A,U,...}. */
final class UltrasonicCommands implements ModuleCommandSet {
    private static final int ADDRESS = ModuleKind.ULTRASONIC.address();

    private final I2cBus bus;
    private int unit = Ultrasonic.CENTIMETRES;

    UltrasonicCommands(I2cBus bus) {
        this.bus = bus;
    }

    @Override
    public Reply answer(char command, String argument) throws ErrorReplyException {
        return switch (command) {
            case 'M' -> measure();
            case 'A' -> echoes();
            case 'E' -> echo(argument);
            case 'L' -> Reply.of("," + Arguments.hex2(bus.read(ADDRESS, Ultrasonic.LIGHT, 0)));
            case 'R' -> range(argument);
            case 'U' -> unit(argument);
            case 'V' -> Reply.of("," + Arguments.hex2(bus.read(ADDRESS, Ultrasonic.COMMAND, 0)));
            default -> throw new ErrorReplyException(ErrorReply.UNKNOWN_MODULE_COMMAND);
        };
    }

    /** Answers when the echoes have arrived. */
    private Reply measure() {
        bus.write(ADDRESS, Ultrasonic.COMMAND, unit);
        return Reply.of("").measuring(Ultrasonic.PING_SECONDS);
    }

    private Reply echoes() {
        StringBuilder reply = new StringBuilder();
        for (int i = 0; i < Ultrasonic.ECHOES; i++) {
            reply.append(',').append(Arguments.hex4(read(i)));
        }
        return Reply.of(reply.toString());
    }

    private Reply echo(String argument) throws ErrorReplyException {
        int echo = Arguments.decimal(argument, 0, Ultrasonic.ECHOES - 1);
        return Reply.of("," + argument + "," + Arguments.hex4(read(echo)));
    }

    /** Its range, mm. */
    private Reply range(String argument) throws ErrorReplyException {
        int steps = Arguments.hex(argument, 4) / Ultrasonic.RANGE_STEP_MM - 1;
        bus.write(ADDRESS, Ultrasonic.RANGE, Math.max(0, Math.min(0xFF, steps)));
        return Reply.of("," + argument);
    }

    private Reply unit(String argument) throws ErrorReplyException {
        unit = switch (argument) {
            case "C" -> Ultrasonic.CENTIMETRES;
            case "I" -> Ultrasonic.INCHES;
            case "U" -> Ultrasonic.MICROSECONDS;
            default -> throw new ErrorReplyException(ErrorReply.SYNTAX);
        };
        return Reply.of("," + argument);
    }

    private int read(int echo) {
        int register = Ultrasonic.FIRST_ECHO + 2 * echo;
        return bus.read(ADDRESS, register, 0) << 8 | bus.read(ADDRESS, register, 1);
    }
}
