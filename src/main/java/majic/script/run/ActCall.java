package majic.script.run;

import java.util.List;
import java.util.stream.Collectors;
import majic.script.syntax.Literal;
import majic.script.syntax.Robots;
import majic.script.syntax.Token;
import org.jspecify.annotations.Nullable;

/**
 * What a line writes to run a behaviour. Immutable.
 *
 * @param name of the behaviour, or its file
 * @param arguments values for its arguments
 * @param others the robots for its further roles, in their order; null for none
 */
public record ActCall(
        Literal name, List<Given> arguments, @Nullable Robots others) {
    /** A value given to an argument: {@code speed=200}. */
    public record Given(Token name, Literal value) {
        @Override
        public String toString() {
            return name.text() + "=" + value.text();
        }
    }

    /** The words that answers repeat. */
    public String text() {
        return text(name.text());
    }

    /** As {@link #text()}, with another name for the behaviour. */
    public String text(String named) {
        String given = arguments.stream().map(one -> " " + one).collect(Collectors.joining());
        return "act " + named + given + (others == null ? "" : " with " + others.text());
    }
}
