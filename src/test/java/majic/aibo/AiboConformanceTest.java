package majic.aibo;

import java.util.List;
import majic.LabRobot;
import majic.drivertest.DriverConformance;
import majic.drivertest.TestedRobot;

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
}
