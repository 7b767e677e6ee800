package majic.shared.panel;

/**
 * What the panel of a shared robot shows beside its parameters. Immutable.
 *
 * @param address of the robot
 * @param holder the user and desk that may move it now; empty if it is free
 * @param heldHere whether that is the program that shows the panel
 * @param delay from a request to the answer of its desk, with its unit
 * @param camera whether it may send pictures
 */
public record SharedScene(String address, String holder, boolean heldHere, String delay, boolean camera) {}
