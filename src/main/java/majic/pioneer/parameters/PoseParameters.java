package majic.pioneer.parameters;

import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import java.util.function.UnaryOperator;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.pioneer.state.Equipment;

/** The parts of the pose, which can be set one by one. Setting them moves nothing and sends nothing. */
final class PoseParameters implements ParameterTheme<Equipment> {
    private static final double FARTHEST_MM = 1_000_000;

    private final PioneerAccess access;
    private final Supplier<Pose> pose;
    private final Consumer<Pose> place;

    /**
     * Creates the parameters.
     *
     * @param pose the pose that users see
     * @param place sets that pose
     */
    PoseParameters(PioneerAccess access, Supplier<Pose> pose, Consumer<Pose> place) {
        this.access = access;
        this.pose = pose;
        this.place = place;
    }

    @Override
    public void describe(ParameterTable table, Equipment equipment) {
        Parameter x = length("x", "how far ahead of where it was added; set corrects it");
        Parameter y = length("y", "how far to the left of where it was added; set corrects it");
        Parameter heading = Parameter.number(
                        "heading", Unit.DEG, "the direction it faces, left positive; set corrects it")
                .within(-360, 360);
        table.add(x, read(Pose::xMm, Unit.MM))
                .writes(values -> put(here -> new Pose(values.get(0).number(), here.yMm(), here.headingDeg())));
        table.add(y, read(Pose::yMm, Unit.MM))
                .writes(values -> put(here -> new Pose(here.xMm(), values.get(0).number(), here.headingDeg())));
        table.add(heading, read(Pose::headingDeg, Unit.DEG))
                .writes(values -> put(
                        here -> new Pose(here.xMm(), here.yMm(), values.get(0).number())));
        if (!equipment.model().known()) {
            describeUnscaled(table);
        }
    }

    /** In place of those that every robot has. */
    private void describeUnscaled(ParameterTable table) {
        Supplier<Value> unknown = () -> PioneerAccess.UNSCALED;
        table.add(Parameter.list("pose", Unit.MM, "x, y and heading"), unknown);
        table.add(Parameter.number("speed", Unit.MM_PER_S, "how fast it goes now, ahead positive"), unknown);
        table.add(Parameter.number("turnRate", Unit.DEG_PER_S, "how fast it turns now, left positive"), unknown);
    }

    private static Parameter length(String name, String help) {
        return Parameter.number(name, Unit.MM, help).within(-FARTHEST_MM, FARTHEST_MM);
    }

    private Supplier<Value> read(ToDoubleFunction<Pose> part, Unit unit) {
        return access.scaled(state -> Value.of(part.applyAsDouble(pose.get()), unit));
    }

    private void put(UnaryOperator<Pose> change) {
        place.accept(change.apply(pose.get()));
    }
}
