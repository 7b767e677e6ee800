package majic.pioneer;

import java.util.List;
import majic.drivertest.DriverConformance;
import majic.drivertest.TestedRobot;
import majic.inlab.LabRobot;

/** Tests the driver with the simulated robot as every driver is tested. */
class PioneerConformanceTest extends DriverConformance {
    @Override
    protected TestedRobot newRobot() {
        return new LabRobot("pioneer");
    }

    @Override
    protected List<String> sensors() {
        return List.of("distanceFront");
    }

    @Override
    protected double brakingMm() {
        return 150;
    }

    /** 1 s while it moves, 3 s while it is stationary (docs/robots/pioneer.md). */
    @Override
    protected double lostWithinS() {
        return 3.5;
    }
}
