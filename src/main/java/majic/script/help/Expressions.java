package majic.script.help;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import majic.script.syntax.Token;
import majic.script.syntax.Token.Kind;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/**
 * Finds what could stand at a place of an expression that is being typed.
 *
 * @param own the robots whose parameters are meant where no robot is named; empty where one must be named
 * @param all the robots that may be named
 * @param named finds the robots that some tokens name
 * @param names those that stand for values
 * @param places the names of the places of the map
 */
record Expressions(
        List<Member> own,
        List<Member> all,
        Function<List<Token>, List<Member>> named,
        VisibleNames names,
        List<String> places) {
    private static final Completion SIGNS = new Completion("", "+ - * /", "a sign, with a blank on each side");
    private static final List<String> ONE_ROBOT = List.of("distance", "bearing");

    private static final List<Completion> FUNCTIONS = List.of(
            new Completion("abs", "VALUE", "the value without its sign"),
            new Completion("bearing", "FROM TO", "the direction from a robot or place to another one, degrees"),
            new Completion("distance", "FROM TO", "the distance between two robots or places, mm"),
            new Completion("max", "VALUE VALUE", "the greater one"),
            new Completion("min", "VALUE VALUE", "the smaller one"),
            new Completion("random", "LOWEST HIGHEST", "a random number between the two"));

    private static final List<String> FUNCTION_WORDS =
            FUNCTIONS.stream().map(Completion::text).toList();

    /** Returns the tokens of the expression at the end of a line; empty if the line does not end in one. */
    static Optional<List<Token>> open(List<Token> tokens) {
        List<Integer> brackets = new ArrayList<>();
        for (int index = 0; index < tokens.size(); index++) {
            if (tokens.get(index).kind() == Kind.LEFT) {
                brackets.add(index);
            } else if (tokens.get(index).kind() == Kind.RIGHT && !brackets.isEmpty()) {
                brackets.remove(brackets.size() - 1);
            }
        }
        if (!brackets.isEmpty() && !isCall(tokens, brackets.get(brackets.size() - 1))) {
            return Optional.of(tokens.subList(brackets.get(brackets.size() - 1) + 1, tokens.size()));
        }
        boolean let =
                tokens.size() > 2 && tokens.get(0).is("let") && tokens.get(2).kind() == Kind.OPERATOR;
        return let ? Optional.of(tokens.subList(3, tokens.size())) : Optional.empty();
    }

    private static boolean isCall(List<Token> tokens, int bracket) {
        return bracket > 1
                && tokens.get(bracket - 1).kind() == Kind.WORD
                && tokens.get(bracket - 2).kind() == Kind.DOT;
    }

    /** Returns what could follow. */
    List<Completion> after(List<Token> expression) {
        if (expression.isEmpty() || isSign(expression.get(expression.size() - 1))) {
            return values();
        }
        Token last = expression.get(expression.size() - 1);
        Token function = function(expression);
        if (function != null && function.isOneOf(ONE_ROBOT)) {
            return ends();
        }
        List<Member> robots = isRobot(last) && !isReading(expression) ? named.apply(List.of(last)) : List.of();
        List<Completion> words = new ArrayList<>(Conditions.readings(robots));
        if (function != null) {
            words.addAll(values());
        }
        return words.isEmpty() ? List.of(SIGNS) : words;
    }

    /** Returns the function whose values are being typed; null if there is none, or if it has all of them. */
    private static @Nullable Token function(List<Token> expression) {
        int takes = 2;
        for (int index = expression.size() - 1; index >= 0 && expression.size() - index <= takes; index--) {
            Token token = expression.get(index);
            if (token.isOneOf(FUNCTION_WORDS)) {
                boolean left = !token.is("abs") || index == expression.size() - 1;
                return left ? token : null;
            }
        }
        return null;
    }

    private static boolean isSign(Token token) {
        return token.kind() == Kind.OTHER || token.kind() == Kind.OPERATOR || token.kind() == Kind.COMMA;
    }

    private static boolean isRobot(Token token) {
        return token.kind() == Kind.NUMBER || token.kind() == Kind.WORD;
    }

    /** Whether the expression ends with a robot and its parameter. */
    private boolean isReading(List<Token> expression) {
        int size = expression.size();
        return size > 1
                && expression.get(size - 1).kind() == Kind.WORD
                && isRobot(expression.get(size - 2))
                && !named.apply(List.of(expression.get(size - 2))).isEmpty();
    }

    private List<Completion> values() {
        List<Completion> words = new ArrayList<>(FUNCTIONS);
        words.addAll(names.values());
        words.addAll(Conditions.readings(own));
        words.addAll(robots());
        words.add(Completion.word("clear", "nothing in range"));
        return words;
    }

    private List<Completion> ends() {
        List<Completion> words = new ArrayList<>(robots());
        places.forEach(name -> words.add(Completion.word(name, "a place of the map")));
        words.addAll(names.values());
        return words;
    }

    /** A value is read from one robot. */
    private List<Completion> robots() {
        return Explained.robots(all).stream()
                .filter(robot -> !robot.text().equals("all"))
                .toList();
    }
}
