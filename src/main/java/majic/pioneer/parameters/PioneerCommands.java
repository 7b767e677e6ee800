package majic.pioneer.parameters;

import java.util.ArrayList;
import java.util.List;
import majic.driver.DriverCommand;
import majic.pioneer.state.Equipment;

/** The commands that only a Pioneer has. */
public final class PioneerCommands {
    /** The names of all of them. */
    public static final List<String> NAMES = List.of("gripper", "carry", "dock", "undock", "tones");

    private final TonesCommand tune;
    private final GripperCommands gripper;
    private final DockCommands dock;

    public PioneerCommands(PioneerAccess access) {
        this.tune = new TonesCommand(access);
        this.gripper = new GripperCommands(access);
        this.dock = new DockCommands(access);
    }

    /** The commands for the equipment of a robot. */
    public List<DriverCommand> with(Equipment equipment) {
        List<DriverCommand> commands = new ArrayList<>();
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

    /** Stops moving parts other than the wheels. */
    public void halt() {
        gripper.halt();
    }
}
