package majic.team;

/**
 * A command that was given manually, with keys, the mouse or a slider. Immutable.
 *
 * @param atNanos when it was sent, on the clock of the team
 * @param text the command in MAJIC Script, without the robot: {@code drive 150 0 for 1.234s}
 */
public record ManualCommand(long atNanos, String text) {}
