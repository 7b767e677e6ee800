package majic.script.syntax;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import majic.script.syntax.Token.Kind;

/**
 * The robots that a command or a condition names.
 *
 * @param at where they are named
 * @param items one or more
 */
public record Robots(Token at, List<Item> items) {
    /** One way to name robots. */
    public sealed interface Item {
        Token at();
    }

    /** By number. */
    public record One(Token at, int number) implements Item {}

    /** Those there are between two numbers, both included. */
    public record Span(Token at, int first, int last) implements Item {}

    /** By a word: all of a type, or the one with this name. */
    public record Named(Token at) implements Item {}

    /** Every robot. */
    public record All(Token at) implements Item {}

    /** In a condition: at least one robot. */
    public record Any(Token at) implements Item {}

    /** The robot that a behaviour runs on. */
    public record Me(Token at) implements Item {}

    /** Parses the names of robots: {@code robots = robot { "," robot } ;}. */
    public static Robots parse(Cursor at) {
        Token first = at.peek();
        List<Item> items = new ArrayList<>();
        do {
            items.add(robot(at));
        } while (at.match(Kind.COMMA));
        return new Robots(first, items);
    }

    /**
     * One robot by its number or a word.
     *
     * @throws ScriptException if the token cannot name a robot
     */
    public static Robots of(Token named) {
        return parse(new Cursor(List.of(named, new Token(Kind.END, "", named.line(), named.end(), named.end()))));
    }

    /** {@code robot = NUMBER | SPAN | "all" | "me" | TYPE | NAME ;} */
    private static Item robot(Cursor at) {
        Token token = at.peek();
        return switch (token.kind()) {
            case NUMBER -> new One(token, at.count("a robot's number"));
            case SPAN -> span(at.advance());
            case WORD -> named(at.advance());
            default -> throw at.unexpected("a robot (a number, a name, a range, a type, all)");
        };
    }

    private static Item span(Token token) {
        String[] ends = token.text().split("-");
        try {
            return new Span(token, Integer.parseInt(ends[0]), Integer.parseInt(ends[1]));
        } catch (NumberFormatException e) {
            throw new ScriptException(token, token.text() + ": robots have smaller numbers");
        }
    }

    private static Item named(Token token) {
        if (token.is("all")) {
            return new All(token);
        }
        return token.is("me") ? new Me(token) : new Named(token);
    }

    public boolean isAny() {
        return items.get(0) instanceof Any;
    }

    public boolean isAll() {
        return items.size() == 1 && items.get(0) instanceof All;
    }

    /** As answers repeat them: {@code 1,3}. */
    public String text() {
        return items.stream().map(item -> item.at().text()).collect(Collectors.joining(","));
    }
}
