package majicsim;

/**
 * The TCP ports at which the robots of a lab listen; 0 takes any free one, and a taken default port is replaced by a
 * free one.
 *
 * @param aibo the Aibo's
 * @param pioneer the Pioneer's
 * @param hemisson the Hemisson's
 * @param ros the ROS robot's, if the lab has one
 */
public record LabPorts(int aibo, int pioneer, int hemisson, int ros) {
    /** Where an Aibo's URBI listens. */
    public static final int AIBO = 54000;

    /** Where a Pioneer listens. */
    public static final int PIONEER = 8101;

    /** Where a rosbridge server listens. */
    public static final int ROS = 9090;

    /** The usual ports of these robots; the Hemisson, a serial robot, has none and takes a free port. */
    public static final LabPorts USUAL = new LabPorts(AIBO, PIONEER, 0, ROS);

    /** Free ports for all robots, so that many labs run side by side. */
    public static final LabPorts FREE = new LabPorts(0, 0, 0, 0);

    /**
     * Checks the ports.
     *
     * @throws IllegalArgumentException if one is not a port number
     */
    public LabPorts {
        for (int port : new int[] {aibo, pioneer, hemisson, ros}) {
            if (port < 0 || port > 65535) {
                throw new IllegalArgumentException("a port must be 0 to 65535, not " + port);
            }
        }
    }
}
