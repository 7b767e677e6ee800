package majic.bot;

import java.util.function.Supplier;
import majic.time.TimeSource;

/** The parameters that every robot has, read from the state that every robot reports (MAJIC Script, "Parameters"). */
final class SharedParameters {
    private SharedParameters() {}

    /** Where they are read. */
    record Source(Supplier<BotState> states, Supplier<BotProfile> profiles, TimeSource time) {
        BotState state() {
            return states.get();
        }

        BotProfile profile() {
            return profiles.get();
        }
    }

    static void describe(ParameterTable table, Source bot) {
        table.add(
                Parameter.number("x", Unit.MM, "how far ahead of where it was added"),
                () -> place(bot, bot.state().pose().xMm(), Unit.MM));
        table.add(
                Parameter.number("y", Unit.MM, "how far to the left of where it was added"),
                () -> place(bot, bot.state().pose().yMm(), Unit.MM));
        table.add(
                Parameter.number("heading", Unit.DEG, "where it looks, left positive"),
                () -> place(bot, bot.state().pose().headingDeg(), Unit.DEG));
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
                () -> Value.of(bot.profile().bodyMm(), Unit.MM));
        table.add(Parameter.number("age", Unit.MS, "time since its last word"), () -> age(bot));
    }

    private static Value place(Source bot, double amount, Unit unit) {
        return new Value.Number(amount, unit, bot.profile().estimates());
    }

    private static Value age(Source bot) {
        long at = bot.state().atNanos();
        return at == 0 ? Value.unknown("no word yet") : Value.of((bot.time().nanos() - at) / 1_000_000, Unit.MS);
    }
}
