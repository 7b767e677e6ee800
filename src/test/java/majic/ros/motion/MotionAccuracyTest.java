package majic.ros.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import majic.bot.MotionReport;
import majic.bot.Pose;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Motions end within 10 mm and 1 degree, whatever the base and its connection are like. */
class MotionAccuracyTest {
    private static final Map<String, BaseModel.Traits> BASES = Map.of(
            "usual", BaseModel.Traits.USUAL,
            "fast odometry", BaseModel.Traits.USUAL.reporting(10, 5),
            "odometry 10 times a second, 200 ms late", BaseModel.Traits.USUAL.reporting(100, 100),
            "odometry 5 times a second, 200 ms late", BaseModel.Traits.USUAL.reporting(200, 100),
            "steps of 0.01", BaseModel.Traits.USUAL.inSteps(),
            "steps of 0.01, 200 ms late", BaseModel.Traits.USUAL.inSteps().reporting(33, 100),
            "not moving below 30 mm/s", BaseModel.Traits.USUAL.sticking(30),
            "heavy", BaseModel.Traits.USUAL.heavy(150),
            "heavy and late", BaseModel.Traits.USUAL.heavy(150).reporting(50, 100),
            "odometry without velocities", BaseModel.Traits.USUAL.withoutVelocities());

    private static final List<Double> DISTANCES_MM = List.of(3.0, 12.0, 50.0, 300.0, 1000.0, -37.0, -500.0);
    private static final List<Double> ANGLES_DEG = List.of(0.4, 2.0, 15.0, 90.0, 180.0, 400.0, -33.0, -720.0);

    static Stream<Arguments> moves() {
        return cases(DISTANCES_MM);
    }

    static Stream<Arguments> turns() {
        return cases(ANGLES_DEG);
    }

    private static Stream<Arguments> cases(List<Double> amounts) {
        List<Arguments> all = new ArrayList<>();
        BASES.keySet().stream()
                .sorted()
                .forEach(name -> amounts.forEach(amount -> all.add(Arguments.of(name, amount))));
        return all.stream();
    }

    @ParameterizedTest(name = "{0}: {1} mm")
    @MethodSource("moves")
    void aMoveEndsWithinTenMillimetres(String name, double mm) {
        try (ModelRobot robot = new ModelRobot(BASES.get(name)).connected()) {
            MotionReport report = robot.bot().move(mm);
            Pose end = robot.truePose();

            assertThat(end.xMm()).isCloseTo(mm, within(10.0));
            assertThat(end.yMm()).isCloseTo(0, within(10.0));
            assertThat(end.headingDeg()).isCloseTo(0, within(1.0));
            assertThat(report.amount().number()).isCloseTo(end.xMm(), within(1.0));
            assertThat(report.seconds()).isLessThan(Math.abs(mm) / 150 * 1.5 + 6);
        }
    }

    @ParameterizedTest(name = "{0}: {1} degrees")
    @MethodSource("turns")
    void aTurnEndsWithinADegree(String name, double degrees) {
        try (ModelRobot robot = new ModelRobot(BASES.get(name)).connected()) {
            MotionReport report = robot.bot().turn(degrees);
            Pose end = robot.truePose();

            assertThat(Pose.normalised(end.headingDeg() - degrees)).isCloseTo(0, within(1.0));
            assertThat(report.amount().number()).isCloseTo(degrees, within(1.2));
            assertThat(report.seconds()).isLessThan(Math.abs(degrees) / 45 * 1.5 + 6);
        }
    }
}
