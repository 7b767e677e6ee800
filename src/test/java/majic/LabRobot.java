package majic;

import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.drivertest.TestedRobot;

/** A robot of an exact lab and its driver, for the conformance tests. */
public final class LabRobot implements TestedRobot {
    private final LabRig rig = LabRig.exact();
    private final String type;
    private final MajicBot bot;

    /** Creates a lab; the driver is not connected. */
    public LabRobot(String type) {
        this.type = type;
        this.bot = rig.session().factory().create("sim:" + type);
    }

    /** Moves the robot by hand to another place of the room. */
    public LabRobot at(double xMm, double yMm, double headingDeg) {
        rig.lab().simulators().place(type, new majicsim.world.Pose(xMm, yMm, headingDeg));
        return this;
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

    @Override
    public void close() {
        bot.close();
        rig.close();
    }
}
