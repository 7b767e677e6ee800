package majic.script.syntax;

import java.util.List;
import java.util.stream.Collectors;

/**
 * The robots a command or a condition speaks of.
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

    /** All of a type. */
    public record OfType(Token at) implements Item {}

    /** Every robot. */
    record All(Token at) implements Item {}

    /** In a condition: at least one robot. */
    record Any(Token at) implements Item {}

    /** The robot a behaviour was given. */
    public record Me(Token at) implements Item {}

    public boolean isAny() {
        return items.get(0) instanceof Any;
    }

    boolean isAll() {
        return items.size() == 1 && items.get(0) instanceof All;
    }

    /** As answers repeat them: {@code 1,3}. */
    public String text() {
        return items.stream().map(item -> item.at().text()).collect(Collectors.joining(","));
    }
}
