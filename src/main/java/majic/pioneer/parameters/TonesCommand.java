package majic.pioneer.parameters;

import java.io.ByteArrayOutputStream;
import java.util.List;
import majic.bot.BotException;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.DriverCommand;
import majic.driver.Motion;
import majic.pioneer.arcos.ArcosCommand;

/** The command {@code tones} of the buzzer (ARCOS sheet 6.1, SAY). */
final class TonesCommand {
    private static final int STEP_MS = 20;
    private static final int MOST_STEPS = 255;
    private static final int MOST_TONES = 20;

    private final PioneerAccess access;

    TonesCommand(PioneerAccess access) {
        this.access = access;
    }

    DriverCommand command() {
        List<Parameter> tone = List.of(
                Parameter.number("duration", Unit.MS, "how long").within(STEP_MS, STEP_MS * MOST_STEPS),
                Parameter.number("note", Unit.NONE, "0 silence, to 127 a MIDI note, above it (note - 127) * 32 Hz")
                        .within(0, 255)
                        .inWholes());
        return new DriverCommand(
                "tones",
                tone,
                tone,
                false,
                "up to 20 tones, each a time (20ms … 5.1s) and a note: 0 silence, to 127 MIDI, above (note - 127) * 32 Hz",
                this::play);
    }

    private String play(List<Value> arguments, Motion motion) {
        if (arguments.size() > 2 * MOST_TONES) {
            throw new BotException("tones: " + arguments.size() / 2 + " are too many, the robot takes " + MOST_TONES);
        }
        ByteArrayOutputStream pairs = new ByteArrayOutputStream();
        for (int index = 0; index < arguments.size(); index += 2) {
            pairs.write((int) Math.round(arguments.get(index).number() / STEP_MS));
            pairs.write((int) arguments.get(index + 1).number());
        }
        access.send(ArcosCommand.SAY.packet(pairs.toByteArray()));
        double seconds = 0;
        for (int index = 0; index < arguments.size(); index += 2) {
            seconds += arguments.get(index).number() / 1000;
        }
        return Value.of(seconds, Unit.S) + " of tones";
    }
}
