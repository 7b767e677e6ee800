package majic.hemisson.modules;

import java.util.List;
import java.util.Locale;
import majic.bot.BotException;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.driver.DriverCommand;
import majic.driver.ParameterTable;
import majic.hemisson.line.Question;
import majic.hemisson.readings.RobotReadings;

/** The speech module behind the RoadNarrows firmware, which takes any text and stored phrases (Hemisson sheet 10). */
final class RoadNarrowsSpeech implements ExtensionModule {
    /** What a command of 50 characters leaves. */
    private static final int LONGEST = Question.LONGEST_TEXT - "A,T,S,".length();

    private static final Question BUSY = Question.ask("A,T,Q", "a,T,Q,[0-9A-Fa-f]{1,2}", Question.msFor(8));

    @Override
    public void describe(ParameterTable table, RobotReadings access) {
        table.add(
                Speech.speaking(),
                access.polledWhileRead(BUSY, reply -> Value.yesNo(!reply.rest().matches("T,Q,0+"))));
    }

    @Override
    public List<DriverCommand> commands(RobotReadings access) {
        Parameter text = Parameter.text("text", "what to say, at most " + LONGEST + " letters");
        return List.of(
                Speech.phrase(number -> access.send(order("C", String.format(Locale.ROOT, "%02d", number)))),
                new DriverCommand("say", List.of(text), false, "speaks a text", (values, motion) -> {
                    access.send(order("S", spoken(values.get(0).toString())));
                    return "speaks";
                }));
    }

    private static Question order(String command, String argument) {
        return Question.ask(
                "A,T," + command + "," + argument, "a,T," + command + "(,.*)?", Question.msFor(6 + argument.length()));
    }

    private static String spoken(String text) {
        if (!text.matches("[ -~]{1," + LONGEST + "}")) {
            throw new BotException("say: 1 to " + LONGEST + " letters and signs of plain English, not " + text.length()
                    + " of \"" + text + "\"");
        }
        return text;
    }
}
