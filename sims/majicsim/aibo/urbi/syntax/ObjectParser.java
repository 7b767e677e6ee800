package majicsim.aibo.urbi.syntax;

import java.util.ArrayList;
import java.util.List;

/** Classes, objects and events (URBI sheet, sections 8 and 10). */
final class ObjectParser {
    private final TokenStream tokens;
    private final ExprParser exprs;

    ObjectParser(TokenStream tokens, ExprParser exprs) {
        this.tokens = tokens;
        this.exprs = exprs;
    }

    Statement classOf() throws SyntaxError {
        tokens.next();
        String name = tokens.expect(TokenKind.IDENTIFIER).text();
        List<String> variables = new ArrayList<>();
        List<String> events = new ArrayList<>();
        if (tokens.match("{")) {
            while (!tokens.match("}")) {
                member(variables, events);
            }
        }
        return new Definition.ClassOf(name, List.copyOf(variables), List.copyOf(events));
    }

    private void member(List<String> variables, List<String> events) throws SyntaxError {
        if (tokens.match(";") || tokens.match(",")) {
            return;
        }
        if (tokens.match("var")) {
            variables.add(tokens.expect(TokenKind.IDENTIFIER).text());
            return;
        }
        boolean event = tokens.match("event");
        if (!event) {
            tokens.expect("function");
        }
        String name = tokens.expect(TokenKind.IDENTIFIER).text();
        if (tokens.at("(")) {
            exprs.arguments();
        }
        if (event) {
            events.add(name);
        }
    }

    Statement creation(Name object) throws SyntaxError {
        tokens.expect("=");
        tokens.expect("new");
        String parent = tokens.expect(TokenKind.IDENTIFIER).text();
        boolean constructs = tokens.at("(");
        return new Definition.New(object, parent, constructs, constructs ? exprs.arguments() : List.of());
    }

    Statement event() throws SyntaxError {
        tokens.next();
        Name name = exprs.name();
        return new Definition.Event(name, tokens.at("(") && !exprs.arguments().isEmpty());
    }

    Statement emission() throws SyntaxError {
        tokens.next();
        Expr durationMs = null;
        if (tokens.match("(")) {
            durationMs = exprs.expr();
            tokens.expect(")");
        }
        Name event = exprs.name();
        return new Flow.Emit(event, tokens.at("(") ? exprs.arguments() : List.of(), durationMs);
    }
}
