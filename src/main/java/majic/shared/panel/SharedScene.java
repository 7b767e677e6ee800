package majic.shared.panel;

/**
 * What the panel of a shared robot shows beside its parameters. Immutable.
 *
 * @param address of the robot
 * @param holder who may move it now: {@link #NOBODY}, {@link #HERE}, or a name
 * @param delay from a request to the answer of its desk, with its unit
 * @param camera whether it may send pictures
 */
public record SharedScene(String address, String holder, String delay, boolean camera) {
    /** Nobody holds the robot. */
    public static final String NOBODY = "nobody";

    /** The program that shows the panel holds the robot. */
    public static final String HERE = "this program";
}
