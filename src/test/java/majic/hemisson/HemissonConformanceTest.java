package majic.hemisson;

import java.util.List;
import majic.drivertest.DriverConformance;
import majic.drivertest.TestedRobot;
import majic.inlab.LabRobot;

/** Tests the driver with the simulated robot as every driver is tested. */
class HemissonConformanceTest extends DriverConformance {
    @Override
    protected TestedRobot newRobot() {
        return new LabRobot("hemisson");
    }

    @Override
    protected List<String> sensors() {
        return List.of("distanceFront");
    }

    /** 4 s behind a serial server (docs/robots/hemisson.md). */
    @Override
    protected double lostWithinS() {
        return 4.5;
    }

    /** A Hemisson has no wheel encoders: its motions are timed. */
    @Override
    protected boolean noticesObstacles() {
        return false;
    }
}
