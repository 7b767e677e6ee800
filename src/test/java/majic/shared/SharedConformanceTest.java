package majic.shared;

import java.util.List;
import majic.drivertest.DriverConformance;
import majic.drivertest.TestedRobot;

/** Tests the driver with a Pioneer of another desk as every driver is tested. */
class SharedConformanceTest extends DriverConformance {
    @Override
    protected TestedRobot newRobot() {
        return new SharedLabRobot("pioneer");
    }

    @Override
    protected List<String> sensors() {
        return List.of("distanceFront", "voltage");
    }

    @Override
    protected double brakingMm() {
        return 150;
    }

    /** The desk is lost when no state has arrived for 3 s. */
    @Override
    protected double lostWithinS() {
        return 3.5;
    }
}
