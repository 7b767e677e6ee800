package majic.mavlink;

import majic.drivertest.DriverConformance;
import majic.drivertest.TestedRobot;
import majic.inlab.LabRig;
import majic.inlab.LabRobot;

/** Tests the driver with the simulated rover, which motions arm, as every driver is tested. */
class MavlinkInLabConformanceTest extends DriverConformance {
    @Override
    protected TestedRobot newRobot() {
        LabRobot robot = new LabRobot("mavlink", LabRig.exactWithMavlink("rover+ready")).at(1200, 0, 0);
        ((MajicMavlink) robot.bot()).armByMotion(true);
        return robot;
    }

    @Override
    protected double moveMm() {
        return 1000;
    }

    @Override
    protected double brakingMm() {
        return 400;
    }

    @Override
    protected double lostWithinS() {
        return 4;
    }
}
