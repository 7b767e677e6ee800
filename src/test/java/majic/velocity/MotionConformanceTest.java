package majic.velocity;

import majic.drivertest.DriverConformance;
import majic.drivertest.TestedRobot;

/** The motions of a base with odometry, as every driver has to perform them. */
class MotionConformanceTest extends DriverConformance {
    @Override
    protected TestedRobot newRobot() {
        return new ModelRobot(BaseModel.Traits.USUAL);
    }

    @Override
    protected double tolerance() {
        return 0.02;
    }
}
