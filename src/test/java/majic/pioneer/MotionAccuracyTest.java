package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Supplier;
import majic.bot.MotionFailed;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Motions end at their target by the robot's odometry, with servers of different behaviour. */
class MotionAccuracyTest {
    private static final List<Supplier<ScriptedPioneer>> MAKES =
            List.of(ScriptedPioneer::robot, ScriptedPioneer::vendorSimulator);

    @ParameterizedTest(name = "{0} mm at {1} mm/s, a SIP every {2} ms, {3} ms late, one in {4} lost")
    @CsvSource({
        "1000, 300, 100, 0, 0",
        "-2000, 300, 100, 0, 0",
        "5000, 1000, 100, 0, 0",
        "1000, 20, 100, 0, 0",
        "5, 300, 100, 0, 0",
        "-5, 300, 200, 100, 0",
        "500, 300, 50, 0, 0",
        "500, 1000, 200, 100, 0",
        "-1500, 600, 200, 100, 3",
        "700, 300, 100, 100, 4",
        "2000, 1000, 100, 20, 5"
    })
    void aMoveEndsWithinTenMillimetres(double mm, double cruise, int cycleMs, int latencyMs, int lost) {
        for (Supplier<ScriptedPioneer> make : MAKES) {
            ScriptedPioneer robot = make.get().every(cycleMs).losingOneIn(lost);
            try (PioneerRig stage = PioneerRig.connected(robot, latencyMs)) {
                stage.bot.set("cruise", cruise);

                assertThat(PioneerRig.amount(stage.bot.move(mm))).isCloseTo(mm, within(10.0));

                assertThat(robot.robot.x()).isCloseTo(mm, within(10.0));
                assertThat(robot.robot.isStationary()).isTrue();
                assertThat(robot.turnsBack()).isLessThanOrEqualTo(1);
            }
        }
    }

    @ParameterizedTest(name = "{0} deg at {1} deg/s, a SIP every {2} ms, {3} ms late, one in {4} lost")
    @CsvSource({
        "90, 50, 100, 0, 0",
        "540, 50, 100, 0, 0",
        "-720, 100, 100, 0, 0",
        "0.5, 50, 100, 0, 0",
        "-2, 50, 200, 100, 0",
        "180, 50, 200, 100, 0",
        "-90, 100, 50, 100, 4",
        "45, 5, 200, 100, 3"
    })
    void aTurnEndsWithinADegree(double degrees, double cruise, int cycleMs, int latencyMs, int lost) {
        for (Supplier<ScriptedPioneer> make : MAKES) {
            ScriptedPioneer robot = make.get().every(cycleMs).losingOneIn(lost);
            try (PioneerRig stage = PioneerRig.connected(robot, latencyMs)) {
                stage.bot.set("cruiseTurn", cruise);

                assertThat(PioneerRig.amount(stage.bot.turn(degrees))).isCloseTo(degrees, within(1.0));

                assertThat(robot.robot.heading()).isCloseTo(degrees, within(1.0));
                assertThat(robot.robot.isStationary()).isTrue();
            }
        }
    }

    @ParameterizedTest(name = "ramps of {0} mm/s² whatever it is told")
    @ValueSource(doubles = {150, 300, 2000})
    void motionsReachTheirTargetWithTheRobotsOwnRamps(double ramp) {
        ScriptedPioneer robot = ScriptedPioneer.robot();
        robot.ignoresRamps = true;
        robot.robot.ramps(ramp, ramp);
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            assertThat(PioneerRig.amount(stage.bot.move(1000))).isCloseTo(1000, within(10.0));
        }
    }

    @Test
    void aRobotThatSticksAtLowSpeedIsSentAHigherSpeed() {
        ScriptedPioneer robot = ScriptedPioneer.robot();
        robot.deadZone = 40;
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            assertThat(PioneerRig.amount(stage.bot.move(12))).isCloseTo(12, within(10.0));
            stage.line.pass(0.1);
            assertThat(robot.heard.stream().filter(order -> order.startsWith("VEL")))
                    .last()
                    .isEqualTo("VEL 0");
        }
    }

    @ParameterizedTest(name = "from counts {0}, {1}")
    @CsvSource({"32700, 0", "-32700, 32760", "16300, -16380", "-16380, -32768"})
    void countersThatWrapOnTheWayAreNoJump(int x, int y) {
        ScriptedPioneer robot = ScriptedPioneer.robot();
        robot.robot.pose(x, y, 0);
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            assertThat(PioneerRig.amount(stage.bot.move(300))).isCloseTo(300, within(10.0));
            assertThat(PioneerRig.amount(stage.bot.move(-600))).isCloseTo(-600, within(10.0));
        }
    }

    @ParameterizedTest(name = "from {0} deg")
    @ValueSource(doubles = {170, 350, -179.5})
    void headingsThatWrapOnTheWayAreNoJump(double heading) {
        ScriptedPioneer robot = ScriptedPioneer.robot();
        robot.robot.pose(0, 0, heading);
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            assertThat(PioneerRig.amount(stage.bot.turn(400))).isCloseTo(400, within(1.0));
            assertThat(PioneerRig.amount(stage.bot.turn(-45))).isCloseTo(-45, within(1.0));
        }
    }

    @Test
    void aMotionOfABlockedRobotFailsWithTheReason() {
        ScriptedPioneer robot = ScriptedPioneer.robot();
        robot.held = true;
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            assertThatThrownBy(() -> stage.bot.move(1000))
                    .isInstanceOf(MotionFailed.class)
                    .hasMessage("commanded to move, it has not moved for 3 s after 0 mm");
        }
    }

    @Test
    void aMotionThatIsTooSlowFailsInTime() {
        ScriptedPioneer robot = ScriptedPioneer.robot();
        DoubleUnaryOperator slowly = speed -> Math.signum(speed) * Math.min(20, Math.abs(speed));
        robot.governor = slowly;
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            double seconds = stage.secondsOf(() -> assertThatThrownBy(() -> stage.bot.move(3000))
                    .isInstanceOf(MotionFailed.class)
                    .hasMessageContaining("not there within"));
            assertThat(seconds).isBetween(20.0, 40.0);
        }
    }

    @Test
    void aGuardActsOnTheReadingThatShowsIt() {
        ScriptedPioneer robot = ScriptedPioneer.robot();
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            double[] atMs = {0};
            stage.bot.move(1000, () -> {
                boolean beyond = stage.bot.state().pose().xMm() > 60;
                atMs[0] = beyond ? stage.line.millis() : 0;
                return beyond;
            });

            long stopMs = robot.heardAt.get(robot.heard.lastIndexOf("STOP 0"));
            assertThat(stopMs - atMs[0]).isLessThanOrEqualTo(2);
            assertThat(robot.robot.isStationary()).isTrue();
        }
    }
}
