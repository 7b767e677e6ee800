package majicsim.aibo.urbi.syntax;

/** A command of a stream with the meaning of the separator behind it: background is a comma, otherwise a semicolon. */
public record SeparatedStatement(Statement statement, boolean background) {}
