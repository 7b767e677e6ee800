package majic.ros;

import majic.drivertest.DriverConformance;
import majic.drivertest.TestedRobot;

/** What holds for every driver, for a base on ROS 1. */
class RosConformanceTest extends DriverConformance {
    @Override
    protected TestedRobot newRobot() {
        return new ScriptedRos();
    }
}
