package majic.script.run;

import java.util.List;
import java.util.stream.Collectors;
import majic.script.syntax.Token;

/**
 * A procedure of a script, {@code to square side}. Its body is set once, behind the lines that may call it: a procedure
 * may call itself.
 */
public final class Procedure {
    private final Token name;
    private final List<Token> arguments;
    private List<Statement> body = List.of();

    /** A procedure without a body. */
    public Procedure(Token name, List<Token> arguments) {
        this.name = name;
        this.arguments = List.copyOf(arguments);
    }

    public Token name() {
        return name;
    }

    /** The names of its arguments, without {@code $}. */
    public List<Token> arguments() {
        return arguments;
    }

    public List<Statement> body() {
        return body;
    }

    public void setBody(List<Statement> statements) {
        body = List.copyOf(statements);
    }

    /** How it is called: {@code square SIDE}. */
    @Override
    public String toString() {
        return name.text()
                + arguments.stream()
                        .map(argument -> " " + argument.text().toUpperCase(java.util.Locale.ROOT))
                        .collect(Collectors.joining());
    }
}
