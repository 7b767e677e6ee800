package majic.pioneer.parameters;

import java.util.List;
import java.util.Optional;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.AssumedSetting;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.state.Equipment;
import majic.pioneer.state.Gripper;

/** The state of gripper and lift. {@link GripperCommands} moves them. */
final class GripperParameters implements ParameterTheme<Equipment> {
    static final int STEP_MS = 20;
    private static final int LONGEST_MS = 5100;
    private static final int GRASP = 16;

    private final PioneerAccess access;
    private final AssumedSetting grasp = new AssumedSetting();

    GripperParameters(PioneerAccess access) {
        this.access = access;
    }

    @Override
    public void describe(ParameterTable table, Equipment equipment) {
        if (!equipment.gripper()) {
            return;
        }
        table.add(
                Parameter.choice("gripper", List.of("open", "closed", "moving", "between"), "position of its paddles"),
                access.state(state -> words(state.gripper(), GripperParameters::paddles)));
        table.add(
                Parameter.choice("lift", List.of("up", "down", "moving", "between"), "position of the gripper's lift"),
                access.state(state -> words(state.gripper(), GripperParameters::lift)));
        table.add(
                        Parameter.number("graspTime", Unit.MS, "how long the paddles press on after they touch")
                                .within(0, LONGEST_MS),
                        access.assumed(grasp))
                .writes(values -> grasp(values.get(0)));
    }

    private void grasp(Value time) {
        access.send(ArcosCommand.GRIPPER.packet(GRASP));
        access.send(grasp, ArcosCommand.GRIPPERVAL.packet((int) Math.round(time.number() / STEP_MS)), time);
    }

    /** Makes a word of a state. */
    private interface Wording {
        String of(Gripper gripper);
    }

    private static Value words(Optional<Gripper> gripper, Wording wording) {
        return gripper.map(state -> Value.text(wording.of(state))).orElse(PioneerAccess.NOT_REPORTED);
    }

    static String paddles(Gripper gripper) {
        if (gripper.moving()) {
            return "moving";
        }
        return gripper.open() ? "open" : gripper.closed() ? "closed" : "between";
    }

    static String lift(Gripper gripper) {
        if (gripper.liftMoving()) {
            return "moving";
        }
        return gripper.liftUp() ? "up" : gripper.liftDown() ? "down" : "between";
    }
}
