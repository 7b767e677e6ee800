package majicsim.aibo;

/** A flag of a tagged command, such as {@code end}. */
record Flag(String name) {}
