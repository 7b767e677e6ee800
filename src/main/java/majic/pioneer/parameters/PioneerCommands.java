package majic.pioneer.parameters;

import java.util.ArrayList;
import java.util.List;
import majic.bot.BotCommand;
import majic.pioneer.state.Equipment;

/** The commands that only a Pioneer has, for what is an act and not a value. */
public final class PioneerCommands {
    /** All that there can be. */
    public static final List<String> NAMES = List.of("gripper", "carry", "dock", "undock", "tones");

    private final TonesCommand tune;
    private final GripperCommands gripper;
    private final DockCommands dock;

    public PioneerCommands(PioneerAccess access) {
        this.tune = new TonesCommand(access);
        this.gripper = new GripperCommands(access);
        this.dock = new DockCommands(access);
    }

    /** Those for what a robot has. */
    public List<BotCommand> with(Equipment equipment) {
        List<BotCommand> commands = new ArrayList<>();
        if (equipment.gripper()) {
            commands.add(gripper.gripper());
            commands.add(gripper.carry());
        }
        if (equipment.charger()) {
            commands.add(dock.dock());
            commands.add(dock.undock());
        }
        commands.add(tune.command());
        return commands;
    }

    /** Stops what moves on the robot besides its wheels. */
    public void halt() {
        gripper.halt();
    }
}
