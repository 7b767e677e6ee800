package majicsim;

/**
 * The TCP ports at which the robots of a lab listen; 0 takes any free one, and a taken default port is replaced by a
 * free one.
 *
 * @param aibo the Aibo's
 * @param pioneer the Pioneer's
 * @param hemisson the Hemisson's
 * @param ros the ROS robot's, if the lab has one
 * @param mavlink the first MAVLink vehicle's, if the lab has any; each further one listens 10 above
 */
public record LabPorts(int aibo, int pioneer, int hemisson, int ros, int mavlink) {
    /** Where an Aibo's URBI listens. */
    public static final int AIBO = 54000;

    /** Where a Pioneer listens. */
    public static final int PIONEER = 8101;

    /** Where a rosbridge server listens. */
    public static final int ROS = 9090;

    /** Where the first MAVLink vehicle listens, as ArduPilot's own simulation. */
    public static final int MAVLINK = 5760;

    /** How far apart the ports of MAVLink vehicles are. */
    static final int MAVLINK_STEP = 10;

    /** The usual ports of these robots; the Hemisson, a serial robot, has none and takes a free port. */
    public static final LabPorts USUAL = new LabPorts(AIBO, PIONEER, 0, ROS, MAVLINK);

    /** Free ports for all robots, so that many labs run side by side. */
    public static final LabPorts FREE = new LabPorts(0, 0, 0, 0, 0);

    /**
     * Checks the ports.
     *
     * @throws IllegalArgumentException if one is not a port number
     */
    public LabPorts {
        for (int port : new int[] {aibo, pioneer, hemisson, ros, mavlink}) {
            if (port < 0 || port > 65535) {
                throw new IllegalArgumentException("a port must be 0 to 65535, not " + port);
            }
        }
    }

    /** The port of a MAVLink vehicle, by its number from 0. */
    int mavlink(int number) {
        return mavlink == 0 ? 0 : mavlink + number * MAVLINK_STEP;
    }
}
