package majicsim.aibo.urbi.syntax;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** Turns one command as the splitter cut it into a tree: separators, tags and flags (URBI sheet, sections 3 and 7). */
final class Parser {
    /** A command that runs needs more stack than an operator. */
    private static final int LEVELS_A_COMMAND = 5;

    private static final Set<String> ENDS = Set.of("else", "onleave", "list");

    private static final Set<String> STARTS = Set.of("(", "[", "-", "!", "$");

    private final TokenStream tokens;
    private final ExprParser exprs;
    private final InstructionParser instructions;

    Parser(List<Token> tokens) {
        this.tokens = new TokenStream(tokens);
        exprs = new ExprParser(this.tokens);
        instructions = new InstructionParser(this.tokens, exprs, this);
    }

    /** The whole command with its separator. */
    SeparatedStatement command() throws SyntaxError {
        Statement statement = atBinary() ? binary() : chain();
        if (tokens.peek().is(TokenKind.END)) {
            return new SeparatedStatement(statement, false);
        }
        boolean background = tokens.at(",");
        boolean ended = background || tokens.at(";");
        if (!ended) {
            boolean counted = !tokens.isFirst() || tokens.at("@");
            throw SyntaxError.expectedEnd(tokens.peek(), counted);
        }
        tokens.next();
        if (!tokens.peek().is(TokenKind.END)) {
            throw SyntaxError.expectedEnd(tokens.peek(), true);
        }
        return new SeparatedStatement(statement, background);
    }

    /** One command with its tag, if it has one. */
    Statement tagged() throws SyntaxError {
        tokens.deeper(LEVELS_A_COMMAND);
        String tag = Statement.NO_TAG;
        List<Flag> flags = List.of();
        if (atTag()) {
            tag = tokens.atName() ? tokens.next().text() : Statement.NO_TAG;
            flags = flags();
            tokens.expect(":");
        }
        Statement body = body();
        tokens.shallower(LEVELS_A_COMMAND);
        return body instanceof Statement.Empty ? body : new Statement.Tagged(tag, flags, body);
    }

    /** Commands joined by {@code &} and {@code |}, which bind alike. */
    private Statement chain() throws SyntaxError {
        int links = 1;
        tokens.deeper();
        Statement left = tagged();
        while (tokens.at("&") || tokens.at("|")) {
            boolean both = tokens.next().is("&");
            tokens.deeper();
            links++;
            Statement right = tagged();
            left = both ? new Statement.Both(left, right) : new Statement.Then(left, right);
        }
        tokens.shallower(links);
        return left;
    }

    private Statement body() throws SyntaxError {
        if (tokens.match("{")) {
            return block();
        }
        return atNothing(tokens.peek()) ? new Statement.Empty() : instructions.instruction();
    }

    /** Whether no command begins with that word or sign; then the command before it is empty. */
    private static boolean atNothing(Token token) {
        return switch (token.kind()) {
            case END -> true;
            case SYMBOL -> !STARTS.contains(token.text());
            case WORD -> ENDS.contains(token.text());
            default -> false;
        };
    }

    private Statement block() throws SyntaxError {
        List<SeparatedStatement> steps = new ArrayList<>();
        boolean open = true;
        while (open) {
            Statement statement = chain();
            boolean background = tokens.match(",");
            open = background || tokens.match(";");
            if (!(statement instanceof Statement.Empty)) {
                steps.add(new SeparatedStatement(statement, background));
            }
        }
        tokens.expect("}");
        return new Statement.Block(List.copyOf(steps));
    }

    private boolean atTag() throws SyntaxError {
        int mark = tokens.mark();
        boolean named = tokens.atName();
        if (named) {
            tokens.next();
        }
        boolean flagged = tokens.peek().is(TokenKind.FLAG);
        boolean found = (named && tokens.at(":")) || flagged;
        tokens.reset(mark);
        return found;
    }

    private List<Flag> flags() throws SyntaxError {
        List<Flag> flags = new ArrayList<>();
        while (tokens.peek().is(TokenKind.FLAG)) {
            String name = tokens.next().text().substring(1);
            Expr argument = null;
            if (tokens.match("(")) {
                argument = exprs.test();
                tokens.expect(")");
            }
            flags.add(new Flag(name, argument));
        }
        return List.copyOf(flags);
    }

    private boolean atBinary() {
        return tokens.atName() && tokens.peek(1).is("=") && tokens.peek(2).is("bin");
    }

    private Statement binary() throws SyntaxError {
        Name target = Name.of(tokens.next().text());
        tokens.expect("=");
        tokens.expect("bin");
        int size = (int) tokens.expect(TokenKind.NUMBER).number();
        List<String> parameters = new ArrayList<>();
        while (tokens.peek().is(TokenKind.NUMBER) || tokens.peek().is(TokenKind.IDENTIFIER)) {
            parameters.add(tokens.next().text());
        }
        return new Action.AssignBinary(target, size, String.join(" ", parameters));
    }
}
