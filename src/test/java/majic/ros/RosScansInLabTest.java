package majic.ros;

import static majic.ros.RosLabSteps.WALL_X_MM;
import static majic.ros.RosLabSteps.connected;
import static majic.ros.RosLabSteps.pass;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.bot.ScanListener;
import majic.inlab.LabRig;
import majic.inlab.LabRobot;
import majicsim.LabOptions;
import majicsim.ros.options.RosOptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The scans of the simulated robot, compared with the room. */
class RosScansInLabTest {
    private static final double X_MM = 3000;

    /** The lab has no noise; what is left is the time of the scans. */
    private static final double NEAR_MM = 5;

    private static final double FOUR_SIGMA_MM = 40;

    private final List<RangeScan> scans = new CopyOnWriteArrayList<>();
    private final ScanListener listener = scans::add;

    /** Where the beam ahead meets the wall, in the frame of the odometry. */
    private static double wallMm(RangeScan scan) {
        Pose scanner = scan.odometry().plus(scan.sensor().beams().get(0).mount());
        return scanner.plus(new Pose(scan.rangeMm(0), 0, 0)).xMm();
    }

    @ParameterizedTest(name = "ROS {0}")
    @ValueSource(strings = {"1", "2", "2+namespace=tb3_0"})
    void theBeamAheadMeetsTheWall(String model) {
        try (LabRobot robot = connected(model, X_MM)) {
            RangeSensor laser = robot.bot().rangeSensors().get(0);
            robot.bot().addScanListener(listener);
            pass(robot, 1.5);

            assertThat(laser.name()).isEqualTo("laser");
            assertThat(laser.beams()).hasSize(360);
            assertThat(scans).hasSizeGreaterThanOrEqualTo(4).allSatisfy(scan -> {
                assertThat(scan.sensor()).isEqualTo(laser);
                assertThat(wallMm(scan)).isCloseTo(WALL_X_MM - X_MM, within(NEAR_MM));
            });
        }
    }

    @Test
    void theWallStaysInItsPlaceWhileTheRobotDrivesAndTurns() {
        try (LabRobot robot = connected("2", X_MM)) {
            robot.bot().addScanListener(listener);
            robot.bot().move(800);
            double fromS = robot.bot().time().nanos() / 1e9;

            assertThat(scans)
                    .hasSizeGreaterThan(10)
                    .allSatisfy(scan -> assertThat(wallMm(scan)).isCloseTo(WALL_X_MM - X_MM, within(NEAR_MM)));
            assertThat(scans).isSortedAccordingTo((one, next) -> Double.compare(one.timeS(), next.timeS()));
            assertThat(scans.get(scans.size() - 1).timeS()).isBetween(fromS - 0.5, fromS);

            robot.bot().turn(30);
            pass(robot, 0.5);
            assertThat(scans.get(scans.size() - 1).odometry().headingDeg()).isCloseTo(30, within(2.0));
        }
    }

    @Test
    void theBeamAheadMeetsTheWallWithinTheNoiseOfTheScanner() {
        LabOptions options = LabOptions.exactOnFreePorts().withNoise(7).withRos(RosOptions.parse("2"));
        try (LabRobot robot = new LabRobot("ros", LabRig.of(options)).at(X_MM, 0, 0)) {
            robot.bot().connect();
            robot.bot().addScanListener(listener);
            pass(robot, 3);

            assertThat(scans)
                    .hasSizeGreaterThan(10)
                    .allSatisfy(scan -> assertThat(wallMm(scan)).isCloseTo(WALL_X_MM - X_MM, within(FOUR_SIGMA_MM)));
            assertThat(scans.stream().mapToDouble(RosScansInLabTest::wallMm).distinct())
                    .hasSizeGreaterThan(5);
        }
    }

    @Test
    void placingTheRobotDoesNotMoveTheOdometryOfItsScans() {
        try (LabRobot robot = connected("1", X_MM)) {
            robot.bot().place(new Pose(7000, -500, 90));
            robot.bot().addScanListener(listener);
            pass(robot, 1);

            assertThat(robot.bot().state().pose().xMm()).isEqualTo(7000);
            assertThat(scans)
                    .isNotEmpty()
                    .allSatisfy(scan ->
                            assertThat(scan.odometry().distanceMm(Pose.START)).isLessThan(1));
        }
    }

    @Test
    void aListenerThatWasRemovedReceivesNoScans() {
        try (LabRobot robot = connected("2", X_MM)) {
            robot.bot().addScanListener(listener);
            pass(robot, 1);
            robot.bot().removeScanListener(listener);
            pass(robot, 0.1);
            int before = scans.size();
            pass(robot, 1);

            assertThat(before).isPositive();
            assertThat(scans).hasSize(before);
            assertThat(robot.bot().get("scanBeams").number()).isEqualTo(360);
        }
    }

    @Test
    void aListenerReceivesScansAgainAfterTheRobotIsConnectedAgain() {
        try (LabRobot robot = connected("2", X_MM)) {
            robot.bot().addScanListener(listener);
            pass(robot, 1);
            robot.cut();
            pass(robot, 1);
            int before = scans.size();

            robot.bot().connect();
            pass(robot, 1);

            assertThat(before).isPositive();
            assertThat(scans).hasSizeGreaterThan(before + 2);
            assertThat(wallMm(scans.get(scans.size() - 1))).isCloseTo(WALL_X_MM - X_MM, within(NEAR_MM));
        }
    }

    @Test
    void aRobotThatIsNotConnectedYetHasNoRangeSensorsAndMayBeAskedForScans() {
        try (LabRobot robot = new LabRobot("ros", LabRig.exactWithRos("2")).at(X_MM, 0, 0)) {
            robot.bot().addScanListener(listener);
            assertThat(robot.bot().rangeSensors()).isEmpty();

            robot.bot().connect();
            pass(robot, 1);

            assertThat(scans).isNotEmpty();
        }
    }
}
