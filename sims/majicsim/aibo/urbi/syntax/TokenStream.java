package majicsim.aibo.urbi.syntax;

import java.util.List;

/** The tokens of one command, read from the front; it also limits the depth of the tree to what the stack allows. */
final class TokenStream {
    private static final int MAX_DEPTH = 1000;

    private final List<Token> tokens;
    private int position;
    private int depth;

    TokenStream(List<Token> tokens) {
        this.tokens = tokens;
    }

    Token peek() {
        return tokens.get(position);
    }

    Token peek(int ahead) {
        return tokens.get(Math.min(position + ahead, tokens.size() - 1));
    }

    Token next() {
        Token token = peek();
        if (position < tokens.size() - 1) {
            position++;
        }
        return token;
    }

    boolean at(String text) {
        return peek().is(text);
    }

    boolean match(String text) {
        boolean matched = at(text);
        if (matched) {
            next();
        }
        return matched;
    }

    /** Takes a sign. The kernel names what it expected only where nothing else could stand, as behind {@code if}. */
    void expect(String text) throws SyntaxError {
        if (!match(text)) {
            throw text.equals("(") ? SyntaxError.unexpected(peek(), text) : SyntaxError.unexpected(peek());
        }
    }

    Token expect(TokenKind kind) throws SyntaxError {
        if (!peek().is(kind)) {
            throw SyntaxError.unexpected(peek(), kind.title());
        }
        return next();
    }

    /** A name with or without a dot. */
    Token expectName() throws SyntaxError {
        if (!atName()) {
            throw SyntaxError.unexpected(peek());
        }
        return next();
    }

    boolean atName() {
        return atName(0);
    }

    boolean atName(int ahead) {
        return peek(ahead).is(TokenKind.IDENTIFIER) || peek(ahead).is(TokenKind.STRUCTURED);
    }

    boolean isFirst() {
        return position == 0;
    }

    int mark() {
        return position;
    }

    void reset(int mark) {
        position = mark;
    }

    /** Counts one more level of nesting or one more link of a chain. */
    void deeper() throws SyntaxError {
        deeper(1);
    }

    void deeper(int levels) throws SyntaxError {
        depth += levels;
        if (depth > MAX_DEPTH) {
            throw new SyntaxError(peek().span(), "memory exhausted", false);
        }
    }

    void shallower(int levels) {
        depth -= levels;
    }
}
