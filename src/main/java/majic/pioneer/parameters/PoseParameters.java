package majic.pioneer.parameters;

import java.util.List;
import java.util.function.UnaryOperator;
import majic.bot.Parameter;
import majic.bot.ParameterTable;
import majic.bot.Pose;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTheme;
import majic.pioneer.session.PioneerSession;
import majic.pioneer.state.Equipment;
import majic.pioneer.state.PioneerState;
import majic.pioneer.state.PoseOffset;

/** The pose. Setting it changes the {@link PoseOffset} and moves nothing. */
final class PoseParameters implements ParameterTheme<Equipment> {
    private static final double FARTHEST_MM = 1_000_000;

    private final PioneerAccess access;
    private final PoseOffset placement;

    PoseParameters(PioneerAccess access, PoseOffset placement) {
        this.access = access;
        this.placement = placement;
    }

    @Override
    public void describe(ParameterTable table, Equipment equipment) {
        Parameter x = length("x", "how far ahead of where it was added; set it to say where it is");
        Parameter y = length("y", "how far to the left of where it was added; set it to say where it is");
        Parameter heading = Parameter.number(
                        "heading", Unit.DEG, "where it looks, left positive; set it to say where it looks")
                .within(-360, 360);
        table.add(x, access.state(state -> Value.of(pose(state).xMm(), Unit.MM)))
                .writes(values -> put(here -> new Pose(values.get(0).number(), here.yMm(), here.headingDeg())));
        table.add(y, access.state(state -> Value.of(pose(state).yMm(), Unit.MM)))
                .writes(values -> put(here -> new Pose(here.xMm(), values.get(0).number(), here.headingDeg())));
        table.add(heading, access.state(state -> Value.of(pose(state).headingDeg(), Unit.DEG)))
                .writes(values -> put(
                        here -> new Pose(here.xMm(), here.yMm(), values.get(0).number())));
        table.add(
                        Parameter.list("pose", Unit.MM, "x, y and heading; what set leaves out stays as it is")
                                .within(-FARTHEST_MM, FARTHEST_MM)
                                .with(y)
                                .with(heading),
                        access.state(state -> all(pose(state))))
                .writes(values -> put(here -> changed(here, values)));
    }

    private static Parameter length(String name, String help) {
        return Parameter.number(name, Unit.MM, help).within(-FARTHEST_MM, FARTHEST_MM);
    }

    private Pose pose(PioneerState state) {
        return placement.of(state.pose());
    }

    private static Value all(Pose pose) {
        return Value.many(List.of(
                Value.of(pose.xMm(), Unit.MM), Value.of(pose.yMm(), Unit.MM), Value.of(pose.headingDeg(), Unit.DEG)));
    }

    private static Pose changed(Pose here, List<Value> values) {
        return new Pose(
                values.get(0).number(),
                values.size() > 1 ? values.get(1).number() : here.yMm(),
                values.size() > 2 ? values.get(2).number() : here.headingDeg());
    }

    /** Returns when the new pose has been published with a SIP. */
    private void put(UnaryOperator<Pose> change) {
        PioneerSession open = access.open();
        PioneerState now = open.state();
        placement.put(now.pose(), change.apply(pose(now)));
        open.reported().await(next -> next.sip() != now.sip(), 1);
    }
}
