package majicsim.aibo.urbi.syntax;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import majicsim.aibo.urbi.value.Value;

/** The commands themselves, one method a form: assignments, definitions and words (URBI sheet, sections 5 to 10). */
final class InstructionParser {
    private static final Set<String> SYSTEM_WORDS = Set.of(
            "ping",
            "quit",
            "connections",
            "devices",
            "vars",
            "uservars",
            "commands",
            "strict",
            "unstrict",
            "stopall",
            "reset",
            "reboot",
            "shutdown",
            "undefall",
            "motoron",
            "motoroff");
    private static final Set<String> REACHING_WORDS = Set.of("disconnect", "killall");
    private static final Set<String> SILENT_WORDS = Set.of("noop", "def", "alias", "group");

    private final TokenStream tokens;
    private final ExprParser exprs;
    private final ControlParser controls;
    private final ObjectParser definitions;

    InstructionParser(TokenStream tokens, ExprParser exprs, Parser parser) {
        this.tokens = tokens;
        this.exprs = exprs;
        controls = new ControlParser(tokens, exprs, parser);
        definitions = new ObjectParser(tokens, exprs);
    }

    Statement instruction() throws SyntaxError {
        if (tokens.peek().is(TokenKind.WORD)) {
            return word();
        }
        if (SYSTEM_WORDS.contains(tokens.peek().text()) && atEnd(1)) {
            return new Action.Command(tokens.next().text());
        }
        if (REACHING_WORDS.contains(tokens.peek().text()) && tokens.atName(1)) {
            return new Action.Reach(tokens.next().text(), tokens.next().text());
        }
        return expression();
    }

    private Statement expression() throws SyntaxError {
        Expr expr = exprs.expr();
        if (expr instanceof Expr.Variable variable && variable.isStatic() && !tokens.at("=")) {
            return new Action.Evaluate(expr);
        }
        if (expr instanceof Expr.Variable variable) {
            return named(variable.name());
        }
        if (expr instanceof Expr.Property property && tokens.match("=")) {
            return new Action.AssignProperty(property.name(), property.property(), exprs.expr());
        }
        return new Action.Evaluate(expr);
    }

    private boolean atEnd(int ahead) {
        Token token = tokens.peek(ahead);
        return token.is(TokenKind.END)
                || token.is(";")
                || token.is(",")
                || token.is("&")
                || token.is("|")
                || token.is("}");
    }

    private Statement word() throws SyntaxError {
        String word = tokens.peek().text();
        if (SILENT_WORDS.contains(word) && atEnd(1)) {
            return new Action.Command(tokens.next().text());
        }
        return switch (word) {
            case "var" -> declaration();
            case "def" -> oldDefinition();
            case "copy", "static" -> expression();
            case "echo" -> echo();
            case "stop", "freeze", "unfreeze", "block", "unblock" -> control();
            case "group", "addgroup", "delgroup" -> grouping();
            case "return" -> giveBack();
            case "undef", "delete" -> undefine();
            case "class" -> definitions.classOf();
            case "event" -> definitions.event();
            case "emit" -> definitions.emission();
            case "info" -> info();
            case "alias", "unalias" -> alias();
            default -> controls.control();
        };
    }

    private Statement named(Name name) throws SyntaxError {
        if (tokens.at("=") && tokens.peek(1).is("new")) {
            return definitions.creation(name);
        }
        if (tokens.match("=")) {
            return new Action.Assign(name, exprs.expr(), modifiers(), false);
        }
        if (tokens.at("+=") || tokens.at("-=")) {
            return new Action.Change(name, tokens.next().is("+=") ? 1 : -1, exprs.expr());
        }
        if (tokens.at("++") || tokens.at("--")) {
            return new Action.Change(name, tokens.next().is("++") ? 1 : -1, new Expr.Constant(Value.of(1)));
        }
        if (tokens.match("switch")) {
            return new Action.Power(name, null);
        }
        if (tokens.peek().is(TokenKind.NUMBER)) {
            return new Action.Power(name, tokens.next().number());
        }
        return new Action.Evaluate(new Expr.Variable(name));
    }

    private Statement declaration() throws SyntaxError {
        tokens.next();
        Name name = exprs.name();
        return tokens.match("=")
                ? new Action.Assign(name, exprs.expr(), modifiers(), true)
                : new Definition.Declare(name);
    }

    /** {@code def x} is an older form of {@code var x}, and {@code def f(x) {…}} of a function's definition. */
    private Statement oldDefinition() throws SyntaxError {
        tokens.next();
        Name name = exprs.name();
        return tokens.at("(") ? controls.definition(name) : new Definition.Declare(name);
    }

    private Statement echo() throws SyntaxError {
        tokens.next();
        return new Action.Echo(exprs.expr(), modifiers());
    }

    private Statement control() throws SyntaxError {
        String word = tokens.next().text();
        return new Action.Control(word, tokens.expectName().text());
    }

    private Statement giveBack() throws SyntaxError {
        tokens.next();
        return new Flow.Return(atEnd(0) ? null : exprs.expr());
    }

    private Statement undefine() throws SyntaxError {
        tokens.next();
        return new Definition.Undefine(exprs.name());
    }

    /** A description of a device, which 1.0 accepts without an answer (URBI sheet, section 9). */
    private Statement info() throws SyntaxError {
        String word = tokens.next().text();
        exprs.name();
        return new Action.Command(word);
    }

    private Statement alias() throws SyntaxError {
        boolean makes = tokens.next().is("alias");
        String name = tokens.expectName().text();
        return new Definition.Alias(name, makes ? tokens.expectName().text() : null);
    }

    private Statement grouping() throws SyntaxError {
        int mark = tokens.mark();
        String word = tokens.next().text();
        String group = tokens.expect(TokenKind.IDENTIFIER).text();
        if (!tokens.match("{")) {
            tokens.reset(mark);
            return new Action.Evaluate(exprs.expr());
        }
        List<String> members = new ArrayList<>();
        do {
            members.add(tokens.expectName().text());
        } while (tokens.match(","));
        tokens.expect("}");
        return new Definition.Grouping(word, group, List.copyOf(members));
    }

    private List<Modifier> modifiers() throws SyntaxError {
        List<Modifier> modifiers = new ArrayList<>();
        while (tokens.peek().is(TokenKind.IDENTIFIER) && tokens.peek(1).is(":")) {
            String name = tokens.next().text();
            tokens.next();
            modifiers.add(new Modifier(name, exprs.expr()));
        }
        return List.copyOf(modifiers);
    }
}
