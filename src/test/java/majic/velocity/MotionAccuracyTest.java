package majic.velocity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import majic.bot.MotionFailed;
import majic.bot.MotionReport;
import majic.bot.Pose;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Motions end within 10 mm and 1 degree, whatever the base and its connection are like, or have failed. */
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

    /** Delays as over a radio link, by the connection, whose round trip is measured, or by the robot's own nodes. */
    private static final Map<String, BaseModel.Traits> LATE_BASES = Map.of(
            "500 ms late", BaseModel.Traits.USUAL.reporting(40, 250).measured(),
            "600 ms late", BaseModel.Traits.USUAL.reporting(40, 300).measured(),
            "heavy, 800 ms late",
                    BaseModel.Traits.USUAL.heavy(150).reporting(40, 400).measured());

    /**
     * Bases that may miss their targets: nothing measures their delay before they move, or they follow no low speed.
     */
    private static final Map<String, BaseModel.Traits> HARD_BASES = Map.of(
            "600 ms late by itself", BaseModel.Traits.USUAL.reporting(40, 300),
            "1200 ms late by itself", BaseModel.Traits.USUAL.reporting(40, 600),
            "not moving below 30 mm/s, 600 ms late",
                    BaseModel.Traits.USUAL.sticking(30).reporting(40, 300).measured(),
            "not moving below 100 mm/s", BaseModel.Traits.USUAL.sticking(100));

    private static final Pattern AFTER = Pattern.compile(".* after (-?[\\d.]+) (mm|deg)");

    private static final List<Double> DISTANCES_MM = List.of(3.0, 12.0, 50.0, 300.0, 1000.0, -37.0, -500.0);
    private static final List<Double> ANGLES_DEG = List.of(0.4, 2.0, 15.0, 90.0, 180.0, 400.0, -33.0, -720.0);

    static Stream<Arguments> moves() {
        return Stream.concat(cases(BASES, DISTANCES_MM), cases(LATE_BASES, DISTANCES_MM));
    }

    static Stream<Arguments> turns() {
        return Stream.concat(cases(BASES, ANGLES_DEG), cases(LATE_BASES, ANGLES_DEG));
    }

    static Stream<Arguments> hardMoves() {
        return cases(HARD_BASES, DISTANCES_MM);
    }

    static Stream<Arguments> hardTurns() {
        return cases(HARD_BASES, ANGLES_DEG);
    }

    private static Stream<Arguments> cases(Map<String, BaseModel.Traits> bases, List<Double> amounts) {
        List<Arguments> all = new ArrayList<>();
        bases.keySet().stream()
                .sorted()
                .forEach(name -> amounts.forEach(amount -> all.add(Arguments.of(name, amount))));
        return all.stream();
    }

    private static ModelRobot connected(String name) {
        return new ModelRobot(BASES.getOrDefault(name, LATE_BASES.get(name))).connected();
    }

    /** Each approach of a late base ends with the wait for the odometry that shows it at rest. */
    private static double mostSeconds(String name, double planned) {
        return planned * 1.5 + (LATE_BASES.containsKey(name) ? 15 : 6);
    }

    @ParameterizedTest(name = "{0}: {1} mm")
    @MethodSource("moves")
    void aMoveEndsWithinTenMillimetres(String name, double mm) {
        try (ModelRobot robot = connected(name)) {
            MotionReport report = robot.bot().move(mm);
            Pose end = robot.truePose();

            assertThat(end.xMm()).isCloseTo(mm, within(10.0));
            assertThat(end.yMm()).isCloseTo(0, within(10.0));
            assertThat(end.headingDeg()).isCloseTo(0, within(1.0));
            assertThat(report.amount().number()).isCloseTo(end.xMm(), within(1.0));
            assertThat(report.seconds()).isLessThan(mostSeconds(name, Math.abs(mm) / 150));
        }
    }

    @ParameterizedTest(name = "{0}: {1} degrees")
    @MethodSource("turns")
    void aTurnEndsWithinADegree(String name, double degrees) {
        try (ModelRobot robot = connected(name)) {
            MotionReport report = robot.bot().turn(degrees);
            Pose end = robot.truePose();

            assertThat(Pose.normalised(end.headingDeg() - degrees)).isCloseTo(0, within(1.0));
            assertThat(report.amount().number()).isCloseTo(degrees, within(1.2));
            assertThat(report.seconds()).isLessThan(mostSeconds(name, Math.abs(degrees) / 45));
        }
    }

    @ParameterizedTest(name = "{0}: {1} mm")
    @MethodSource("hardMoves")
    void aMoveThatIsDoneWasMadeAndAnotherOneFailsWithTheDistanceCovered(String name, double mm) {
        try (ModelRobot robot = new ModelRobot(HARD_BASES.get(name)).connected()) {
            double reported = amount(() -> robot.bot().move(mm), mm, 10);

            assertThat(robot.truePose().xMm()).isCloseTo(reported, within(1.0));
            assertThat(robot.base.mmPerSec()).isZero();
        }
    }

    @ParameterizedTest(name = "{0}: {1} degrees")
    @MethodSource("hardTurns")
    void aTurnThatIsDoneWasMadeAndAnotherOneFailsWithTheAngleCovered(String name, double degrees) {
        try (ModelRobot robot = new ModelRobot(HARD_BASES.get(name)).connected()) {
            double reported = amount(() -> robot.bot().turn(degrees), degrees, 1);

            assertThat(Pose.normalised(robot.truePose().headingDeg() - reported))
                    .isCloseTo(0, within(1.0));
        }
    }

    /** Returns what a motion reports, done or failed; one that is done has to be near its target. */
    private static double amount(Supplier<MotionReport> motion, double target, double tolerance) {
        try {
            double done = motion.get().amount().number();
            assertThat(done).isCloseTo(target, within(tolerance));
            return done;
        } catch (MotionFailed e) {
            Matcher after = AFTER.matcher(String.valueOf(e.getMessage()));
            assertThat(after.matches()).as(e.getMessage()).isTrue();
            return Double.parseDouble(after.group(1));
        }
    }
}
