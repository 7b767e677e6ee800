package majicsim.aibo.urbi;

/** A command of a stream with the meaning of the separator behind it: background is a comma, otherwise a semicolon. */
record Step(Statement statement, boolean background) {}
