package majic.script.help;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;
import majic.bot.Parameter;
import majic.script.syntax.Token;
import majic.team.Member;

/**
 * Finds what could stand at a place of a condition that is being typed.
 *
 * @param own the robots whose parameters are meant where no robot is named; empty where one must be named
 * @param all the robots that may be named
 * @param named finds the robots that some tokens name
 */
record Conditions(List<Member> own, List<Member> all, Function<List<Token>, List<Member>> named) {
    private static final List<String> JOINING = List.of("and", "or", "not");

    /** Returns what could follow; empty where the parser knows what is expected. */
    List<Completion> after(List<Token> condition) {
        List<Token> comparison = lastComparison(condition);
        if (comparison.isEmpty()) {
            return beginning();
        }
        Token last = comparison.get(comparison.size() - 1);
        if (last.kind() == Token.Kind.OPERATOR) {
            return values(comparison);
        }
        if (comparison.stream().anyMatch(token -> token.kind() == Token.Kind.OPERATOR)) {
            return List.of(Completion.word("and", "both conditions hold"), Completion.word("or", "one of them holds"));
        }
        return last.kind() == Token.Kind.COMMA ? Explained.robots(all) : readings(named(comparison));
    }

    private static List<Token> lastComparison(List<Token> condition) {
        int start = condition.size();
        while (start > 0 && !begins(condition.get(start - 1))) {
            start--;
        }
        return condition.subList(start, condition.size());
    }

    private static boolean begins(Token before) {
        return before.isOneOf(JOINING) || before.kind() == Token.Kind.LEFT;
    }

    private List<Completion> beginning() {
        List<Completion> words = new ArrayList<>(readings(own));
        words.addAll(Explained.robots(all));
        words.add(Completion.word("any", "at least one robot"));
        words.add(Completion.word("not", "the condition does not hold"));
        return words;
    }

    /** The parameters of some robots that can be read. */
    static List<Completion> readings(List<Member> members) {
        return readable(members).map(Explained::parameter).toList();
    }

    private static Stream<Parameter> readable(List<Member> members) {
        return members.stream()
                .flatMap(member -> member.bot().parameters().stream())
                .filter(Parameter::readable);
    }

    /** The robots that are named; none if the tokens end with a parameter. */
    private List<Member> named(List<Token> comparison) {
        return comparison.get(0).is("any") && comparison.size() == 1 ? all : named.apply(comparison);
    }

    /** The values and the other parameters that a parameter can be compared with. */
    private List<Completion> values(List<Token> comparison) {
        Token name = comparison.get(Math.max(0, comparison.size() - 2));
        List<Token> robots = comparison.subList(0, Math.max(0, comparison.size() - 2));
        List<Member> members = robots.isEmpty() ? own : named(robots);
        List<Completion> words = new ArrayList<>();
        readable(members).filter(left -> name.is(left.name())).forEach(left -> {
            words.addAll(Explained.values(left));
            if (left.kind() == Parameter.Kind.NUMBER) {
                words.add(Completion.word("clear", "nothing in range"));
                readable(members)
                        .filter(right -> right.kind() == left.kind()
                                && right.unit() == left.unit()
                                && !right.name().equals(left.name()))
                        .map(Explained::parameter)
                        .forEach(words::add);
            }
        });
        return words;
    }
}
