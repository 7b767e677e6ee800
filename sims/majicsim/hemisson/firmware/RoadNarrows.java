package majicsim.hemisson.firmware;

import java.util.Locale;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majicsim.hemisson.board.CommandBuffer;
import majicsim.hemisson.board.Motors;
import majicsim.hemisson.board.RobotControl;
import majicsim.hemisson.modules.I2cBus;
import majicsim.hemisson.modules.ModuleKind;
import majicsim.hemisson.modules.Voice;
import majicsim.hemisson.uart.Reply;

/**
 * HemiOS 1.50-RNe (sheet 10): replies repeat their arguments, errors have numbers, and modules are addressed by command
 * A. A command that is not in the sheet is answered as K-Team's firmware does.
 */
public final class RoadNarrows implements Interpreter {
    private static final String GREETING = "HemiOS V1.50-RNe" + Commands.GREETING_END;
    private static final Pattern SPEEDS = Pattern.compile("D,(-?\\d+),(-?\\d+)");
    private static final Pattern BUZZER = Pattern.compile("H,([01])");
    private static final Pattern LEDS = Pattern.compile("L,[01],[01],[01],[01]");
    private static final int FASTEST = 9;

    /** The sheet names a stamp and general I/O, but not their commands. */
    private static final String NAMED_ONLY = "2GD";

    private final CommandBuffer buffer;
    private final Commands stock;
    private final Motors motors;
    private final RobotControl control;
    private final I2cBus bus;
    private final Map<Character, ModuleCommandSet> modules;

    public RoadNarrows(CommandBuffer buffer, Commands stock, Motors motors, I2cBus bus, RobotControl control) {
        this.buffer = buffer;
        this.stock = stock;
        this.motors = motors;
        this.control = control;
        this.bus = bus;
        this.modules = Map.of(
                ModuleKind.CAMERA.letter(), new CameraCommands(bus),
                ModuleKind.ULTRASONIC.letter(), new UltrasonicCommands(bus),
                ModuleKind.SPEECH.letter(), new VoiceCommands(bus));
    }

    @Override
    public String greeting() {
        return GREETING;
    }

    @Override
    public Reply carryOut() {
        if (buffer.hasOverflowed()) {
            return ErrorReply.OVERFLOW.reply();
        }
        return switch (buffer.at(0)) {
            case 'A' -> module(buffer.text());
            case 'B' -> Reply.line("b,HemiOS_v_1.50-RNe");
            case 'D' -> drive();
            case 'E' -> Reply.line("e," + motors.left() + "," + motors.right());
            case 'H' -> echo(BUZZER);
            case 'J' -> scan();
            case 'L' -> echo(LEDS);
            case 'I', 'M', 'N', 'O', 'P', 'Q', 'R', 'S', 'T', 'U', 'W', 'X', 'Y', 'Z', '1', '2', '!', '&', '*' ->
                stock.carryOut();
            default -> ErrorReply.UNKNOWN_COMMAND.reply();
        };
    }

    /**
     * Command A: the letter, the module's id, its own command and maybe arguments, between commas. The answer repeats
     * the command before the module's answer.
     */
    private Reply module(String text) {
        String[] words = text.split(",", 4);
        if (words.length < 3 || words[1].length() != 1 || words[2].length() != 1 || words[0].length() != 1) {
            return ErrorReply.SYNTAX.reply();
        }
        char id = words[1].charAt(0);
        ModuleCommandSet commands = modules.get(id);
        if (commands == null) {
            return (NAMED_ONLY.indexOf(id) >= 0 ? ErrorReply.NOT_SUPPORTED : ErrorReply.BAD_MODULE).reply();
        }
        if (bus.awake().stream().noneMatch(module -> module.letter() == id)) {
            return ErrorReply.NOT_CONNECTED.reply();
        }
        try {
            Reply reply = commands.answer(words[2].charAt(0), words.length > 3 ? words[3] : "");
            return Reply.line("a," + id + "," + words[2] + reply.text()).measuring(reply.measuringSeconds());
        } catch (ErrorReplyException e) {
            return e.error().reply();
        }
    }

    private Reply drive() {
        Matcher speeds = SPEEDS.matcher(buffer.text());
        if (!speeds.matches()) {
            return ErrorReply.SYNTAX.reply();
        }
        if (!isSpeed(speeds, 1) || !isSpeed(speeds, 2)) {
            return ErrorReply.RANGE.reply();
        }
        int left = Integer.parseInt(speeds.group(1));
        int right = Integer.parseInt(speeds.group(2));
        control.drive(left, right);
        return Reply.line("d," + left + "," + right);
    }

    /** Executes it like K-Team's firmware, and repeats the whole command. */
    private Reply echo(Pattern syntax) {
        String text = buffer.text();
        if (!syntax.matcher(text).matches()) {
            return ErrorReply.SYNTAX.reply();
        }
        stock.carryOut();
        return Reply.line(text.substring(0, 1).toLowerCase(Locale.ROOT) + text.substring(1));
    }

    private Reply scan() {
        StringBuilder reply = new StringBuilder("j");
        for (ModuleKind module : bus.awake()) {
            int version = bus.read(module.address(), module == ModuleKind.SPEECH ? Voice.VERSION_REGISTER : 0, 0);
            reply.append(String.format(Locale.ROOT, ",%c,%02X,%02X", module.letter(), module.address(), version));
        }
        return Reply.line(reply.toString()).scanning(ModuleCommands.SCAN_SECONDS);
    }

    private static boolean isSpeed(MatchResult speeds, int group) {
        String digits = speeds.group(group);
        return digits.length() <= 2 && Math.abs(Integer.parseInt(digits)) <= FASTEST;
    }
}
