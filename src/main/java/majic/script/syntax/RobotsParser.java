package majic.script.syntax;

import java.util.ArrayList;
import java.util.List;
import majic.script.syntax.Robots.Item;
import majic.script.syntax.Token.Kind;

/** The rule for naming robots. */
public final class RobotsParser {
    private static final String ROBOT = "a robot (a number, a range, a type, all)";

    private final Cursor at;

    public RobotsParser(Cursor at) {
        this.at = at;
    }

    /** Reads the names of robots: {@code robots = robot { "," robot } ;}. */
    public Robots robots() {
        Token first = at.peek();
        List<Item> items = new ArrayList<>();
        do {
            items.add(robot());
        } while (at.match(Kind.COMMA));
        return new Robots(first, items);
    }

    /** {@code robot = NUMBER | SPAN | "all" | "me" | TYPE ;} */
    private Item robot() {
        Token token = at.peek();
        return switch (token.kind()) {
            case NUMBER -> new Robots.One(token, at.count("a robot's number"));
            case SPAN -> span(at.advance());
            case WORD -> named(at.advance());
            default -> throw at.unexpected(ROBOT);
        };
    }

    private static Item span(Token token) {
        String[] ends = token.text().split("-");
        try {
            return new Robots.Span(token, Integer.parseInt(ends[0]), Integer.parseInt(ends[1]));
        } catch (NumberFormatException e) {
            throw new ScriptException(token, token.text() + ": robots have smaller numbers");
        }
    }

    private static Item named(Token token) {
        if (token.is("all")) {
            return new Robots.All(token);
        }
        return token.is("me") ? new Robots.Me(token) : new Robots.OfType(token);
    }
}
