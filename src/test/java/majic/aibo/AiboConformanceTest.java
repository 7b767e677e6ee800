package majic.aibo;

import java.util.List;
import majic.drivertest.DriverConformance;
import majic.drivertest.TestedRobot;
import majic.inlab.LabRobot;

/** Tests the driver with the simulated robot as every driver is tested. */
class AiboConformanceTest extends DriverConformance {
    @Override
    protected TestedRobot newRobot() {
        return new LabRobot("aibo");
    }

    @Override
    protected List<String> sensors() {
        return List.of("distanceFront");
    }

    /** The driver gives the dog up 4 s after the last reading (docs/robots/aibo.md). */
    @Override
    protected double lostWithinS() {
        return 4.5;
    }

    /** A dog that walks on the spot in front of a wall does not notice it. */
    @Override
    protected boolean noticesObstacles() {
        return false;
    }
}
