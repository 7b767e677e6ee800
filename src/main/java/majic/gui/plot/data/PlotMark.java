package majic.gui.plot.data;

/**
 * A moment that is marked in plots: a command began or ended. Immutable.
 *
 * @param seconds when, on the clock of the plot's source
 * @param robot the robot's number; 0 for all robots
 * @param text the command, or how it ended
 * @param end whether it ended
 */
public record PlotMark(double seconds, int robot, String text, boolean end) {}
