package majicsim.aibo.urbi.syntax;

/** A point in a connection's program text; line and column count from 1. */
public record Place(int line, int column) {
    Place after(char c) {
        return c == '\n' ? new Place(line + 1, 1) : new Place(line, column + 1);
    }
}
