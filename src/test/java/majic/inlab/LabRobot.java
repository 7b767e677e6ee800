package majic.inlab;

import java.util.function.Consumer;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.drivertest.TestedRobot;
import majicsim.mavlink.MavlinkHandling;
import majicsim.ros.RosHandling;

/** A robot of an exact lab and its driver, for the conformance tests. */
public final class LabRobot implements TestedRobot {
    private static final double FOR_EVER_S = 1e6;
    private static final double WALL_X_MM = 4500;
    private static final double GAP_MM = 30;

    private final LabRig rig;
    private final String type;
    private final MajicBot bot;

    /** Creates a lab; the driver is not connected. */
    public LabRobot(String type) {
        this(type, LabRig.exact());
    }

    /** Uses a lab, which is closed with the robot; the driver is not connected. */
    public LabRobot(String type, LabRig rig) {
        this.rig = rig;
        this.type = type;
        this.bot = rig.session().factory().create("sim:" + type);
    }

    /** Moves the robot by hand to another place of the room. */
    public LabRobot at(double xMm, double yMm, double headingDeg) {
        rig.lab().simulators().place(type, new majicsim.world.Pose(xMm, yMm, headingDeg));
        return this;
    }

    /** Orders faults of the ROS robot and its computer. */
    public void besideRos(Consumer<RosHandling> action) {
        rig.lab().simulators().besideRos(action);
    }

    /** Acts on a MAVLink vehicle itself. */
    public void besideMavlink(Consumer<MavlinkHandling> action) {
        rig.lab().simulators().besideMavlink(type, action);
    }

    /** Makes a second driver of the robot, as another program has one; not connected, to be closed. */
    public MajicBot another() {
        return rig.session().factory().create("sim:" + type);
    }

    @Override
    public MajicBot bot() {
        return bot;
    }

    @Override
    public Pose truePose() {
        return rig.truePose(type);
    }

    @Override
    public void cut() {
        rig.lab().simulators().faults(type).cut();
    }

    /** Delays all bytes of its line, in both directions. */
    public void delayLine(double ms) {
        rig.lab().simulators().faults(type).delay(ms);
    }

    @Override
    public void fallSilent() {
        rig.lab().simulators().faults(type).outage(FOR_EVER_S);
    }

    /** Moves the robot by hand to a wall. */
    @Override
    public void block() {
        at(WALL_X_MM - bot.profile().bodyMm() - GAP_MM, 0, 0);
    }

    @Override
    public void unblock() {
        at(WALL_X_MM / 2, 0, 0);
    }

    @Override
    public void close() {
        bot.close();
        rig.close();
    }
}
