package majic.pioneer.parameters;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToIntFunction;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.driver.AssumedSetting;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.state.Bumpers;
import majic.pioneer.state.Equipment;
import majic.pioneer.state.PioneerState;

/** Contacts and what blocks the robot: bumpers, stalls, the STOP button, steps. */
final class ContactParameters implements ParameterTheme<Equipment> {
    /** As BUMPSTALL numbers them (ARCOS sheet 6.1, 17). */
    private static final List<String> SIDES = List.of("none", "front", "rear", "both");

    private final PioneerAccess access;
    private final AssumedSetting bumpStall = new AssumedSetting();

    ContactParameters(PioneerAccess access) {
        this.access = access;
    }

    @Override
    public void describe(ParameterTable table, Equipment equipment) {
        Bumpers bumpers = equipment.bumpers();
        table.add(
                Parameter.yesNo("bumped", "whether a bumper is touched or a motor stalled"),
                access.state(state -> Value.yesNo(bumpers.touched(state) || state.stalled())));
        flag(table, "stallLeft", "whether the left motor is stalled", PioneerState::stallLeft);
        flag(table, "stallRight", "whether the right motor is stalled", PioneerState::stallRight);
        flag(table, "stopButton", "whether the STOP button on the robot is pressed", PioneerState::stopButton);
        flag(table, "stopEngaged", "whether the STOP button still holds the motors off", PioneerState::stopEngaged);
        flag(table, "ledge", "whether an infra-red sensor looks down a step", PioneerState::ledge);
        if (bumpers.frontSegments() + bumpers.rearSegments() > 0) {
            table.add(
                    Parameter.text("bumpers", "the touched segments: \"front 2, rear 1\", or \"none\""),
                    access.state(state -> Value.text(touched(bumpers, state))));
            describeStall(table);
        }
        segments(table, "bumpFront", bumpers.frontSegments(), bumpers::front);
        segments(table, "bumpRear", bumpers.rearSegments(), bumpers::rear);
    }

    private void describeStall(ParameterTable table) {
        table.add(
                        Parameter.choice("bumpStall", SIDES, "the bumpers that stop the robot by themselves"),
                        access.assumed(bumpStall))
                .writes(values -> access.send(
                        bumpStall,
                        ArcosCommand.BUMPSTALL.packet(
                                SIDES.indexOf(values.get(0).toString())),
                        values.get(0)));
    }

    /** A condition of a state. */
    private interface Question {
        boolean of(PioneerState state);
    }

    private void flag(ParameterTable table, String name, String help, Question question) {
        table.add(Parameter.yesNo(name, help), access.state(state -> Value.yesNo(question.of(state))));
    }

    private void segments(ParameterTable table, String name, int count, ToIntFunction<PioneerState> bits) {
        for (int number = 1; number <= count; number++) {
            int bit = 1 << number - 1;
            flag(
                    table,
                    name + number,
                    "whether this segment of the bumper is touched",
                    state -> (bits.applyAsInt(state) & bit) != 0);
        }
    }

    private static String touched(Bumpers bumpers, PioneerState state) {
        List<String> touched = new ArrayList<>();
        for (int bit = 0; bit < bumpers.frontSegments(); bit++) {
            if ((bumpers.front(state) >> bit & 1) != 0) {
                touched.add("front " + (bit + 1));
            }
        }
        for (int bit = 0; bit < bumpers.rearSegments(); bit++) {
            if ((bumpers.rear(state) >> bit & 1) != 0) {
                touched.add("rear " + (bit + 1));
            }
        }
        return touched.isEmpty() ? "none" : String.join(", ", touched);
    }
}
