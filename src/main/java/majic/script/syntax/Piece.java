package majic.script.syntax;

/** What one line is to the block it is typed into. */
public sealed interface Piece {
    /** Where the line begins. */
    Token at();

    /** Nothing but blanks and a comment. */
    record Nothing(Token at) implements Piece {}

    /** A whole command. */
    record Plain(Token at, Statement statement) implements Piece {}

    /** The head of a block, here without a body. */
    record Open(Token at, Statement head) implements Piece {}

    /** The {@code else} of an {@code if}. */
    record Otherwise(Token at) implements Piece {}

    /** The {@code end} of a block. */
    record Close(Token at) implements Piece {}
}
