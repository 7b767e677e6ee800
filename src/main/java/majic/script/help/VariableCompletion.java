package majic.script.help;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.script.syntax.Scanner;
import majic.script.syntax.Token;

/** Completes the names that stand for values, such as {@code $speed}. */
public final class VariableCompletion {
    private static final Pattern BEGUN = Pattern.compile("\\$[\\p{L}\\d_]*$");

    private VariableCompletion() {}

    /**
     * Completes the name in front of a place.
     *
     * @param names those that the line may use
     * @param typed the line up to that place
     * @return empty if no such name ends there
     */
    public static Optional<Completions> complete(VisibleNames names, String typed) {
        Matcher begun = BEGUN.matcher(typed);
        return begun.find() && !isText(typed, begun.start())
                ? Optional.of(new Completions(begun.start(), names(names.values(), begun.group())))
                : Optional.empty();
    }

    /** Whether a place lies in a text in quotes or in a comment. */
    private static boolean isText(String typed, int place) {
        List<Token> tokens =
                Scanner.scan(typed).stream().filter(token -> !token.isEnd()).toList();
        Token last = tokens.isEmpty() ? null : tokens.get(tokens.size() - 1);
        return last == null || last.end() - 1 <= place || last.kind() == Token.Kind.OPEN_QUOTE;
    }

    private static List<Completion> names(List<Completion> values, String begun) {
        return values.stream()
                .filter(entry -> entry.text().toLowerCase(Locale.ROOT).startsWith(begun.toLowerCase(Locale.ROOT)))
                .toList();
    }
}
