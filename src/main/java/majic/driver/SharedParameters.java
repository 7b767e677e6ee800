package majic.driver;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import majic.bot.BotProfile;
import majic.bot.BotState;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.Uncertainty;
import majic.bot.Unit;
import majic.bot.Value;
import majic.time.TimeSource;

/** The parameters that every robot has, read from the state that every robot reports (MAJIC Script, "Parameters"). */
final class SharedParameters {
    private static final double FARTHEST_MM = 1_000_000;

    private SharedParameters() {}

    /** Where they are read. */
    record Source(
            Supplier<BotState> states,
            Supplier<Uncertainty> uncertainty,
            Supplier<BotProfile> profiles,
            TimeSource time) {
        BotState state() {
            return states.get();
        }

        BotProfile profile() {
            return profiles.get();
        }
    }

    /**
     * Adds them to a table.
     *
     * @param place sets the pose that the robot reports at its present place
     */
    static void describe(ParameterTable table, Source bot, Consumer<Pose> place) {
        describePlace(table, bot);
        describePose(table, bot, place);
        table.add(
                Parameter.number("speed", Unit.MM_PER_S, "how fast it goes now, ahead positive"),
                () -> place(bot, bot.state().speedMmPerSec(), Unit.MM_PER_S));
        table.add(
                Parameter.number("turnRate", Unit.DEG_PER_S, "how fast it turns now, left positive"),
                () -> place(bot, bot.state().turnRateDegPerSec(), Unit.DEG_PER_S));
        table.add(
                Parameter.yesNo("moving", "whether it moves"),
                () -> Value.yesNo(bot.state().moving()));
        table.add(
                        Parameter.number("body", Unit.MM, "radius of a circle it fits in"),
                        () -> Value.of(bot.profile().bodyMm(), Unit.MM))
                .kept();
        table.add(Parameter.number("age", Unit.MS, "time since its last report"), () -> age(bot))
                .kept();
    }

    private static void describePlace(ParameterTable table, Source bot) {
        table.add(
                Parameter.number("x", Unit.MM, "how far ahead of where it was added"),
                () -> place(bot, bot.state().pose().xMm(), Unit.MM));
        table.add(
                Parameter.number("y", Unit.MM, "how far to the left of where it was added"),
                () -> place(bot, bot.state().pose().yMm(), Unit.MM));
        table.add(
                Parameter.number("heading", Unit.DEG, "the direction it faces, left positive"),
                () -> place(bot, bot.state().pose().headingDeg(), Unit.DEG));
    }

    private static void describePose(ParameterTable table, Source bot, Consumer<Pose> place) {
        Parameter pose = Parameter.list(
                        "pose", Unit.MM, "x, y and heading; set corrects them; what set leaves out stays as it is")
                .within(-FARTHEST_MM, FARTHEST_MM)
                .with(Parameter.number("y", Unit.MM, "to the left").within(-FARTHEST_MM, FARTHEST_MM))
                .with(Parameter.number("heading", Unit.DEG, "left positive").within(-360, 360));
        table.add(
                        pose,
                        () -> Value.many(List.of(
                                place(bot, bot.state().pose().xMm(), Unit.MM),
                                place(bot, bot.state().pose().yMm(), Unit.MM),
                                place(bot, bot.state().pose().headingDeg(), Unit.DEG))))
                .writes(values -> place.accept(changed(bot.state().pose(), values)));
        table.add(
                Parameter.list("placed", Unit.MM, "the standard deviations of its place on the map and of its heading")
                        .with(Parameter.number("heading", Unit.DEG, "of the heading")),
                () -> placed(bot.uncertainty().get()));
    }

    private static Value placed(Uncertainty uncertainty) {
        return uncertainty.isKnown()
                ? Value.many(
                        List.of(Value.of(uncertainty.sigmaMm(), Unit.MM), Value.of(uncertainty.sigmaDeg(), Unit.DEG)))
                : Value.unknown("not placed");
    }

    private static Pose changed(Pose here, List<Value> values) {
        return new Pose(
                values.get(0).number(),
                values.size() > 1 ? values.get(1).number() : here.yMm(),
                values.size() > 2 ? values.get(2).number() : here.headingDeg());
    }

    private static Value place(Source bot, double amount, Unit unit) {
        return new Value.Number(amount, unit, bot.profile().estimates());
    }

    private static Value age(Source bot) {
        long at = bot.state().atNanos();
        return at == 0 ? Value.unknown("no report yet") : Value.of((bot.time().nanos() - at) / 1_000_000, Unit.MS);
    }
}
