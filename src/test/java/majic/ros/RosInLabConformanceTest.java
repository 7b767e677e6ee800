package majic.ros;

import java.util.List;
import majic.drivertest.DriverConformance;
import majic.drivertest.TestedRobot;
import majic.inlab.LabRig;
import majic.inlab.LabRobot;

/** Tests the driver with the simulated robot, on ROS 2 and without a command time-out, as every driver is tested. */
class RosInLabConformanceTest extends DriverConformance {
    /** The dialect of the robot and its server. */
    protected String model() {
        return "2";
    }

    @Override
    protected final TestedRobot newRobot() {
        return new LabRobot("ros", LabRig.exactWithRos(model())).at(1000, 0, 0);
    }

    @Override
    protected double tolerance() {
        return 0.04;
    }

    @Override
    protected List<String> sensors() {
        return List.of();
    }

    /** 1 s, and the time between two checks (docs/robots/ros.md). */
    @Override
    protected double lostWithinS() {
        return 1.5;
    }
}
