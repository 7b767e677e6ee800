package majic.mavlink;

import majic.drivertest.DriverConformance;
import majic.drivertest.TestedRobot;

/** What holds for every driver, for a rover with ArduPilot. */
class MavlinkConformanceTest extends DriverConformance {
    @Override
    protected TestedRobot newRobot() {
        DrivenRover robot = new DrivenRover();
        robot.rover.armed = true;
        return robot;
    }

    @Override
    protected double moveMm() {
        return 2000;
    }

    @Override
    protected double brakingMm() {
        return 300;
    }

    @Override
    protected double lostWithinS() {
        return 4;
    }
}
