package majic.aibo.parameters;

import java.util.List;
import majic.aibo.body.DogState;
import majic.aibo.body.Joint;
import majic.aibo.urbi.UrbiCommands;
import majic.aibo.urbi.UrbiVersion;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.Motion;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;

/** How stiff each joint is. A dog whose legs go loose falls over, so setting it is a motion. */
final class LoadParameters implements ParameterTheme<UrbiVersion> {
    private final AiboAccess access;
    private final DogState dog;

    LoadParameters(AiboAccess access, DogState dog) {
        this.dog = dog;
        this.access = access;
    }

    @Override
    public void describe(ParameterTable table, UrbiVersion version) {
        for (Joint joint : Joint.values()) {
            String variable = joint.urbiName() + ".load";
            table.add(
                            Parameter.number(joint.urbiName() + "Load", Unit.NONE, "its stiffness; 0 loose, 1 stiff")
                                    .within(0, 1),
                            access.asked(variable, load -> Value.of(load, Unit.NONE)))
                    .moves((values, motion) ->
                            stiffen(joint, variable, values.get(0).number(), motion));
        }
    }

    private void stiffen(Joint joint, String variable, double load, Motion motion) {
        access.open().joints().perform(List.of(UrbiCommands.assign(variable, load)), 0, motion);
        if (joint.isInALeg()) {
            dog.setStanding(false);
        }
    }
}
