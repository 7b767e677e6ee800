package majicsim.hemisson.firmware;

import java.util.Map;
import majicsim.hemisson.modules.I2cBus;
import majicsim.hemisson.modules.ModuleKind;
import majicsim.hemisson.uart.Reply;

/** Command A of the RoadNarrows dialect: finds the module, and repeats the command before the module's answer. */
final class RoadNarrowsModules {
    /** The sheet names a stamp and general I/O, but not their commands. */
    private static final String NAMED_ONLY = "2GD";

    private final I2cBus bus;
    private final Map<Character, ModuleCommandSet> speakers;

    RoadNarrowsModules(I2cBus bus) {
        this.bus = bus;
        speakers = Map.of(
                ModuleKind.CAMERA.letter(), new CameraCommands(bus),
                ModuleKind.ULTRASONIC.letter(), new UltrasonicCommands(bus),
                ModuleKind.SPEECH.letter(), new VoiceCommands(bus));
    }

    /** The whole command: A, the module's id, its own command and maybe arguments, between commas. */
    Reply carryOut(String text) {
        String[] words = text.split(",", 4);
        if (words.length < 3 || words[1].length() != 1 || words[2].length() != 1 || words[0].length() != 1) {
            return ErrorReply.SYNTAX.reply();
        }
        char id = words[1].charAt(0);
        ModuleCommandSet speaker = speakers.get(id);
        if (speaker == null) {
            return (NAMED_ONLY.indexOf(id) >= 0 ? ErrorReply.NOT_SUPPORTED : ErrorReply.BAD_MODULE).reply();
        }
        if (bus.awake().stream().noneMatch(module -> module.letter() == id)) {
            return ErrorReply.NOT_CONNECTED.reply();
        }
        try {
            Reply reply = speaker.answer(words[2].charAt(0), words.length > 3 ? words[3] : "");
            return Reply.line("a," + id + "," + words[2] + reply.text()).measuring(reply.measuringSeconds());
        } catch (ErrorReplyException e) {
            return e.error().reply();
        }
    }
}
