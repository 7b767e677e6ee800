package majic.hemisson.parameters;

import java.util.function.Supplier;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.hemisson.line.LinkQuality;
import majic.hemisson.modules.Modules;

/** How fast and how reliably the robot answers. */
final class AnswerParameters implements ParameterTheme<Modules> {
    private final Supplier<LinkQuality> quality;

    AnswerParameters(Supplier<LinkQuality> quality) {
        this.quality = quality;
    }

    @Override
    public void describe(ParameterTable table, Modules modules) {
        table.add(
                Parameter.number("roundTrip", Unit.MS, "from a question to its answer, a mean of the last ones"),
                () -> Value.of(quality.get().roundTripMs(), Unit.MS));
        table.add(
                Parameter.number("missedAnswers", Unit.NONE, "that did not come in time, since it was connected"),
                () -> Value.of(quality.get().misses(), Unit.NONE));
    }
}
