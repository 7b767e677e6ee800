package majicsim.aibo.urbi.syntax;

/** A named part behind an assignment or an echo, such as {@code time:500}. */
public record Modifier(String name, Expr value) {}
