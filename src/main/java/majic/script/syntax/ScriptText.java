package majic.script.syntax;

import java.util.Collection;
import java.util.List;
import java.util.regex.Pattern;

/** The text of a whole script, to be parsed at once. */
public final class ScriptText {
    /** How many characters a line may have. */
    public static final int LONGEST_LINE = 4000;

    /** What a longer line is refused with. */
    public static final String TOO_LONG = "the line is longer than " + LONGEST_LINE + " characters";

    private static final Pattern LINES = Pattern.compile("\\R");

    private ScriptText() {}

    /**
     * Parses a script; checks nothing that depends on robots.
     *
     * @param types the words that stand for all robots of a type
     * @param mistakes receives what is wrong, in the order of the text
     */
    public static List<Statement> parse(String text, Collection<String> types, List<Mistake> mistakes) {
        String[] lines = LINES.split(text, -1);
        for (int index = 0; index < lines.length; index++) {
            if (lines[index].length() > LONGEST_LINE) {
                mistakes.add(new Mistake(index + 1, 1, TOO_LONG));
                return List.of();
            }
        }
        Parser parser = new Parser(Scanner.scan(text), types);
        List<Statement> script = parser.script();
        mistakes.addAll(parser.mistakes());
        return script;
    }
}
