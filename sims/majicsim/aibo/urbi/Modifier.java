package majicsim.aibo.urbi;

/** A named part behind an assignment or an echo, such as {@code time:500}. */
record Modifier(String name, Expr value) {}
