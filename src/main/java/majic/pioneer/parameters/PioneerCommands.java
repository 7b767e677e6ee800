package majic.pioneer.parameters;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.List;
import majic.bot.BotException;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.DriverCommand;
import majic.driver.Motion;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.state.Equipment;

/** The commands that only a Pioneer has. Those that move its gripper or its dock need permission, as motions do. */
public final class PioneerCommands {
    /** The names of all of them. */
    public static final List<String> NAMES = List.of("gripper", "carry", "dock", "undock", "tones");

    /** Time for the docking mechanism to reach its contacts, seconds. */
    private static final double CONTACT_S = 5;

    private static final int TONE_STEP_MS = 20;
    private static final int MOST_TONE_STEPS = 255;
    private static final int MOST_TONES = 20;

    private final PioneerAccess access;
    private final GripperCommands gripper;

    public PioneerCommands(PioneerAccess access) {
        this.access = access;
        this.gripper = new GripperCommands(access);
    }

    /** The commands for the equipment of a robot. */
    public List<DriverCommand> with(Equipment equipment) {
        List<DriverCommand> commands = new ArrayList<>();
        if (equipment.gripper()) {
            commands.add(gripper.gripper());
            commands.add(gripper.carry());
        }
        if (equipment.charger()) {
            commands.add(new DriverCommand(
                    "dock",
                    List.of(),
                    true,
                    "lowers the contacts onto the charger below it",
                    (none, motion) -> dock(motion)));
            commands.add(new DriverCommand(
                    "undock", List.of(), true, "lifts the contacts off the charger", (none, motion) -> undock(motion)));
        }
        commands.add(tones());
        return commands;
    }

    /** Stops moving parts other than the wheels. */
    public void halt() {
        gripper.halt();
    }

    private String dock(Motion motion) {
        motion.send(() -> access.send(ArcosCommand.CHARGE.packet(1)));
        return motion.await(this::hasPower, CONTACT_S)
                ? "docked, the charger has power"
                : "contacts lowered; no power from a charger";
    }

    private String undock(Motion motion) {
        boolean docked = hasPower();
        motion.send(() -> access.send(ArcosCommand.CHARGE.packet(0)));
        if (!docked) {
            return "contacts lifted; there was no power from a charger before";
        }
        return motion.await(() -> !hasPower(), CONTACT_S) ? "undocked" : "sent; the charger still has power";
    }

    private boolean hasPower() {
        return access.open().state().power().chargerConnected();
    }

    /** The buzzer (ARCOS sheet 6.1, SAY). */
    private DriverCommand tones() {
        List<Parameter> tone = List.of(
                Parameter.number("duration", Unit.MS, "how long").within(TONE_STEP_MS, TONE_STEP_MS * MOST_TONE_STEPS),
                Parameter.number("note", Unit.NONE, "0 silence, to 127 a MIDI note, above it (note - 127) * 32 Hz")
                        .within(0, 255)
                        .inWholes());
        return new DriverCommand(
                "tones",
                tone,
                tone,
                false,
                "up to 20 tones, each a time (20ms … 5.1s) and a note: 0 silence, to 127 MIDI, above (note - 127) * 32 Hz",
                (arguments, motion) -> play(arguments));
    }

    private String play(List<Value> arguments) {
        if (arguments.size() > 2 * MOST_TONES) {
            throw new BotException("tones: " + arguments.size() / 2 + " are too many, the robot takes " + MOST_TONES);
        }
        ByteArrayOutputStream pairs = new ByteArrayOutputStream();
        double ms = 0;
        for (int index = 0; index < arguments.size(); index += 2) {
            double duration = arguments.get(index).number();
            ms += duration;
            pairs.write((int) Math.round(duration / TONE_STEP_MS));
            pairs.write((int) arguments.get(index + 1).number());
        }
        access.send(ArcosCommand.SAY.packet(pairs.toByteArray()));
        return Value.of(ms / 1000, Unit.S) + " of tones";
    }
}
