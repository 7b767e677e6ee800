package majic.hemisson;

import java.util.List;
import majic.bot.BotCommand;
import majic.bot.BotException;
import majic.bot.Parameter;
import majic.bot.ParameterTable;

/** The speech module behind the RoadNarrows firmware, which takes any text (Hemisson sheet 10). */
final class RoadNarrowsSpeech implements ExtensionModule {
    private static final String SAY = "A,T,S,";

    /** Between the commas of a command of 50 characters. */
    private static final int LONGEST = Question.LONGEST_TEXT - SAY.length();

    @Override
    public void describe(ParameterTable table, Access access) {
        new Speech().describe(table, access);
    }

    @Override
    public List<BotCommand> commands(Access access) {
        Parameter text = Parameter.text("text", "what to say, at most " + LONGEST + " letters");
        return List.of(new BotCommand("say", List.of(text), false, "speaks a text", (values, motion) -> {
            access.tell(Question.ask(SAY + spoken(values.get(0).toString()), "a,T,S(,.*)?", Question.msFor(8)));
            return "speaks";
        }));
    }

    private static String spoken(String text) {
        if (!text.matches("[ -~]{1," + LONGEST + "}")) {
            throw new BotException("say: 1 to " + LONGEST + " letters and signs of plain English, not " + text.length()
                    + " of \"" + text + "\"");
        }
        return text;
    }
}
