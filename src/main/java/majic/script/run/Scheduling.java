package majic.script.run;

/** When a command runs, seen from the lines before and behind it. */
public enum Scheduling {
    /** A stop: at once, before all lines that wait. */
    STOP,
    /** At once, past a wait; from a pipe or socket only if no line waits. */
    OVERTAKES,
    /** An answer to a script: at once, past all lines that wait for the script; from a pipe in its turn. */
    ANSWERS,
    /** At once if no line waits. */
    AT_ONCE,
    /** At once if typed and no line waits; from a pipe or socket in its turn, since it waits for what it ends. */
    AT_ONCE_IF_TYPED,
    /** Takes its time: if typed, it runs beside the next lines. */
    BESIDE,
    /** Connects a robot: beside the next lines, but one such line after the other. */
    BESIDE_IN_ORDER,
    /** Holds the lines behind it until it has ended. */
    HOLDS
}
