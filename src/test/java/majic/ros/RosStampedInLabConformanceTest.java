package majic.ros;

/** Tests the driver with the simulated robot on ROS 2 with stamped velocities, in a namespace. */
class RosStampedInLabConformanceTest extends RosInLabConformanceTest {
    @Override
    protected String model() {
        return "2+stamped+timeout=0.5+namespace=tb3";
    }
}
