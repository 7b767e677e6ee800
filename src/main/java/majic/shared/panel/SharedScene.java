package majic.shared.panel;

/**
 * What the panel of a shared robot shows beside its parameters. Immutable.
 *
 * @param address of the robot
 * @param holder who may move it now
 * @param delay from a request to the answer of its desk, with its unit
 * @param camera whether it may send pictures
 */
public record SharedScene(String address, String holder, String delay, boolean camera) {}
