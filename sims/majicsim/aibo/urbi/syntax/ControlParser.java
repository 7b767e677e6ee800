package majicsim.aibo.urbi.syntax;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** Control flow, events and function definitions (URBI sheet, sections 8 and 10). */
final class ControlParser {
    private final TokenStream tokens;
    private final ExprParser exprs;
    private final Parser parser;

    ControlParser(TokenStream tokens, ExprParser exprs, Parser parser) {
        this.tokens = tokens;
        this.exprs = exprs;
        this.parser = parser;
    }

    Statement control() throws SyntaxError {
        Token word = tokens.next();
        return switch (word.text()) {
            case "if" -> choice();
            case "while" -> new Flow.While(joined().test("("), parser.tagged(), null);
            case "for" -> count();
            case "loop" -> new Flow.Loop(null, joined().parser.tagged());
            case "loopn" -> new Flow.Loop(joined().test("("), parser.tagged());
            case "foreach" -> foreach();
            case "every" -> new Flow.Every(test("("), parser.tagged());
            case "wait" -> new Flow.Wait(exprs.expr());
            case "waituntil" -> new Flow.WaitUntil(test("("));
            case "timeout", "stopif", "freezeif" -> new Flow.Watched(word.text(), test("("), parser.tagged());
            case "at" -> new Flow.At(joined().test("("), parser.tagged(), otherwise("onleave"));
            case "whenever" -> new Flow.Whenever(joined().test("("), parser.tagged(), otherwise("else"));
            case "function" -> definition(exprs.name());
            default -> throw SyntaxError.unexpected(word);
        };
    }

    /** Skips the separator that may follow a loop's word: each round takes a cycle with any separator. */
    private ControlParser joined() {
        if (!tokens.match("&")) {
            tokens.match("|");
        }
        return this;
    }

    private Expr test(String open) throws SyntaxError {
        tokens.expect(open);
        Expr test = exprs.test();
        tokens.expect(")");
        return test;
    }

    private Statement choice() throws SyntaxError {
        return new Flow.If(test("("), parser.tagged(), otherwise("else"));
    }

    private @Nullable Statement otherwise(String word) throws SyntaxError {
        return tokens.match(word) ? parser.tagged() : null;
    }

    /** {@code for (first; test; step) body} is its first part, then a while loop. */
    private Statement count() throws SyntaxError {
        joined();
        tokens.expect("(");
        Statement first = parser.tagged();
        tokens.expect(";");
        Expr test = exprs.test();
        tokens.expect(";");
        Statement step = parser.tagged();
        tokens.expect(")");
        return new Statement.Then(first, new Flow.While(test, parser.tagged(), step));
    }

    private Statement foreach() throws SyntaxError {
        joined();
        String variable = tokens.expect(TokenKind.IDENTIFIER).text();
        tokens.expect("in");
        Expr list = exprs.expr();
        if (!tokens.at("{")) {
            throw SyntaxError.unexpected(tokens.peek());
        }
        return new Flow.Foreach(variable, list, parser.tagged());
    }

    /** The parameters and the body behind a function's name. */
    Statement definition(Name function) throws SyntaxError {
        tokens.expect("(");
        List<String> parameters = new ArrayList<>();
        while (!tokens.match(")")) {
            if (!parameters.isEmpty()) {
                tokens.expect(",");
            }
            tokens.match("var");
            parameters.add(tokens.expect(TokenKind.IDENTIFIER).text());
        }
        return new Definition.Define(function, List.copyOf(parameters), parser.tagged());
    }
}
