package majic.script.help;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import majic.act.ActArgument;
import majic.script.syntax.Token;
import majic.script.syntax.Token.Kind;

/** Finds what may follow the name of an act in a line: arguments that are not given yet, and the values of one. */
final class ActCompletion {
    private static final Completion WITH = new Completion("with", "ROBOTS", "further robots of the act");

    private final List<Token> tokens;
    private final Function<String, List<ActArgument>> arguments;

    /**
     * Creates a finder.
     *
     * @param tokens those behind the word {@code act}, up to the word to complete; at least one
     * @param arguments the arguments of an act; may read its file
     */
    ActCompletion(List<Token> tokens, Function<String, List<ActArgument>> arguments) {
        this.tokens = tokens;
        this.arguments = arguments;
    }

    List<Completion> entries() {
        Token last = tokens.get(tokens.size() - 1);
        if (last.kind() == Kind.OPERATOR && tokens.size() > 1) {
            String name = tokens.get(tokens.size() - 2).text();
            return known().stream()
                    .filter(argument -> argument.isNamed(name))
                    .flatMap(argument -> Explained.values(argument).stream())
                    .toList();
        }
        List<Completion> entries = new ArrayList<>(known().stream()
                .filter(argument -> !isGiven(argument))
                .map(Explained::argument)
                .toList());
        entries.add(WITH);
        return entries;
    }

    private List<ActArgument> known() {
        return arguments.apply(name());
    }

    /** Returns the name of the act: the tokens that stand together behind a bracket of a call, without quotes. */
    private String name() {
        int start = tokens.get(0).kind() == Kind.LEFT ? 1 : 0;
        StringBuilder name = new StringBuilder();
        for (int index = start; index < tokens.size(); index++) {
            Token token = tokens.get(index);
            boolean apart = index > start && tokens.get(index - 1).end() != token.column();
            if (apart || token.kind() == Kind.COMMA) {
                break;
            }
            name.append(token.text());
        }
        return name.toString();
    }

    private boolean isGiven(ActArgument argument) {
        for (int index = 1; index < tokens.size(); index++) {
            if (tokens.get(index).kind() == Kind.OPERATOR
                    && argument.isNamed(tokens.get(index - 1).text())) {
                return true;
            }
        }
        return false;
    }
}
