package majicsim.aibo.urbi.syntax;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import majicsim.aibo.urbi.value.Value;

/** Expressions, one method a level of precedence (URBI sheet, section 5); loosest first. */
final class ExprParser {
    private static final List<Set<String>> LEVELS = List.of(
            Set.of("||", "&&"),
            Set.of("==", "~=", "%=", "=~=", "!=", ">", ">=", "<", "<="),
            Set.of("+", "-"),
            Set.of("*", "/", "%"));
    private static final int TEST_LEVEL = 1;
    private static final Set<String> SUFFIXES = Set.of("'n", "'", "''", "'d", "'dd", "'e", "'in", "'out");

    private final TokenStream tokens;

    ExprParser(TokenStream tokens) {
        this.tokens = tokens;
    }

    Expr expr() throws SyntaxError {
        return binary(0);
    }

    /** A test, which may end with how long it must hold. */
    Expr test() throws SyntaxError {
        Expr test = expr();
        return tokens.match("~") ? new Expr.Soft(test, expr()) : test;
    }

    Name name() throws SyntaxError {
        Name name;
        if (tokens.match("$")) {
            tokens.expect("(");
            name = new Name("", expr(), List.of(), "");
            tokens.expect(")");
        } else {
            name = Name.of(tokens.expectName().text());
        }
        return suffixed(indexed(name));
    }

    /** Expressions in brackets, as behind a function's name. */
    List<Expr> arguments() throws SyntaxError {
        tokens.expect("(");
        return list(")");
    }

    private Expr binary(int level) throws SyntaxError {
        if (level == LEVELS.size()) {
            return negation();
        }
        int links = 1;
        tokens.deeper();
        Expr left = operand(level);
        while (tokens.peek().is(TokenKind.SYMBOL)
                && LEVELS.get(level).contains(tokens.peek().text())) {
            String operator = tokens.next().text();
            tokens.deeper();
            links++;
            left = new Expr.Binary(operator, left, operand(level));
        }
        tokens.shallower(links);
        return left;
    }

    /** {@code !} binds as loosely as {@code &&}: it takes the whole comparison behind it. */
    private Expr operand(int level) throws SyntaxError {
        if (level == 0 && tokens.match("!")) {
            tokens.deeper();
            Expr operand = operand(0);
            tokens.shallower(1);
            return new Expr.Unary("!", operand);
        }
        return binary(level + 1);
    }

    /** {@code copy} has the same operands as minus. Values are immutable here, so the copy is the value itself. */
    private Expr negation() throws SyntaxError {
        boolean copies = tokens.at("copy");
        if (!copies && !tokens.at("-")) {
            return power();
        }
        tokens.next();
        tokens.deeper();
        Expr operand = negation();
        tokens.shallower(1);
        return copies ? operand : new Expr.Unary("-", operand);
    }

    private Expr power() throws SyntaxError {
        Expr base = primary();
        if (!tokens.match("^")) {
            return base;
        }
        tokens.deeper();
        Expr exponent = negation();
        tokens.shallower(1);
        return new Expr.Binary("^", base, exponent);
    }

    private Expr primary() throws SyntaxError {
        Token token = tokens.peek();
        switch (token.kind()) {
            case NUMBER, TIME -> {
                return new Expr.Constant(Value.of(tokens.next().number()));
            }
            case STRING -> {
                return new Expr.Constant(Value.of(tokens.next().text()));
            }
            case IDENTIFIER, STRUCTURED -> {
                return named();
            }
            default -> {
                return signed(token);
            }
        }
    }

    private Expr signed(Token token) throws SyntaxError {
        if (tokens.match("!")) {
            return new Expr.Unary("!", binary(TEST_LEVEL));
        }
        if (tokens.match("(")) {
            Expr inner = test();
            tokens.expect(")");
            return inner;
        }
        if (tokens.match("[")) {
            return new Expr.Items(list("]"));
        }
        if (tokens.match("static")) {
            return new Expr.Variable(name(), true);
        }
        if (tokens.match("group")) {
            return new Expr.Members(tokens.expect(TokenKind.IDENTIFIER).text());
        }
        if (token.is("$")) {
            return named();
        }
        throw SyntaxError.unexpected(token);
    }

    private Expr named() throws SyntaxError {
        Name name = name();
        if (tokens.match("(")) {
            return new Expr.Call(name, list(")"));
        }
        if (tokens.match("->")) {
            return new Expr.Property(name, tokens.next().text());
        }
        return new Expr.Variable(name);
    }

    private Name indexed(Name name) throws SyntaxError {
        List<Expr> keys = new ArrayList<>();
        while (tokens.match("[")) {
            keys.add(expr());
            if (!tokens.match("]")) {
                throw SyntaxError.unexpected(tokens.peek());
            }
        }
        return keys.isEmpty() ? name : name.with(List.copyOf(keys));
    }

    private Name suffixed(Name name) {
        Token token = tokens.peek();
        if (!token.is(TokenKind.SYMBOL) || !SUFFIXES.contains(token.text())) {
            return name;
        }
        return name.withSuffix(tokens.next().text());
    }

    private List<Expr> list(String end) throws SyntaxError {
        List<Expr> items = new ArrayList<>();
        if (tokens.match(end)) {
            return items;
        }
        do {
            items.add(expr());
        } while (tokens.match(","));
        if (!tokens.match(end)) {
            throw SyntaxError.unexpected(tokens.peek());
        }
        return List.copyOf(items);
    }
}
