package majic.ros;

/** Tests the driver with the simulated robot on ROS 1, which stops by itself. */
class Ros1InLabConformanceTest extends RosInLabConformanceTest {
    @Override
    protected String model() {
        return "1";
    }
}
