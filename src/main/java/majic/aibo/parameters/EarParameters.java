package majic.aibo.parameters;

import java.util.ArrayList;
import java.util.List;
import majic.aibo.urbi.UrbiCommands;
import majic.aibo.urbi.UrbiVersion;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.Motion;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;

/** The ears, which have two positions each (URBI sheet 13). */
final class EarParameters implements ParameterTheme<UrbiVersion> {
    private static final List<String> EARS = List.of("earL", "earR");

    private final AiboAccess access;

    EarParameters(AiboAccess access) {
        this.access = access;
    }

    @Override
    public void describe(ParameterTable table, UrbiVersion version) {
        describe(table, "earL", "whether the left ear is flicked");
        describe(table, "earR", "whether the right ear is flicked");
        Parameter right = Parameter.number("earR", Unit.NONE, "the right ear").within(0, 1);
        table.add(
                        Parameter.list("ears", Unit.NONE, "left and right ear; 1 is flicked")
                                .within(0, 1)
                                .with(right),
                        access.askedAll(EARS.stream().map(ear -> ear + ".val").toList(), Unit.NONE))
                .moves(this::flick);
    }

    private void describe(ParameterTable table, String ear, String help) {
        table.add(Parameter.onOff(ear, help), access.asked(ear + ".val", amount -> Value.onOff(amount > 0)))
                .moves((values, motion) -> access.open()
                        .joints()
                        .perform(
                                List.of(UrbiCommands.assign(
                                        ear + ".val", values.get(0).number())),
                                0,
                                motion));
    }

    private void flick(List<Value> values, Motion motion) {
        List<String> commands = new ArrayList<>();
        for (int index = 0; index < values.size(); index++) {
            commands.add(UrbiCommands.assign(
                    EARS.get(index) + ".val", Math.rint(values.get(index).number())));
        }
        access.open().joints().perform(commands, 0, motion);
    }
}
