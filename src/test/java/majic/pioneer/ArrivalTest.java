package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Whether motions end where they should, by the robot's own odometry, with servers unlike in many ways. */
@Timeout(60)
class ArrivalTest {
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
        for (ScriptedPioneer robot : new ScriptedPioneer[] {ScriptedPioneer.robot(), ScriptedPioneer.vendorSimulator()}) {
            robot.cycleMs = cycleMs;
            robot.losesOneSipIn = lost;
            try (Stage stage = Stage.connected(robot, latencyMs)) {
                stage.bot.set("cruise", cruise);

                double[] covered = {0};
                double seconds = stage.secondsOf(() -> covered[0] = Stage.amount(stage.bot.move(mm)));

                System.err.printf("%s %.0f at %.0f cyc %d lat %d lost %d: %.1f in %.1f s, back %.0f%n", robot.subclass, mm, cruise, cycleMs, latencyMs, lost, robot.robot.x(), seconds,
                    robot.speeds.stream().mapToDouble(v -> -v * Math.signum(mm)).max().orElse(0));
                assertThat(covered[0]).isCloseTo(mm, within(10.0));
                assertThat(robot.robot.x()).isCloseTo(mm, within(10.0));
                assertThat(robot.robot.stands()).isTrue();
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
        for (ScriptedPioneer robot : new ScriptedPioneer[] {ScriptedPioneer.robot(), ScriptedPioneer.vendorSimulator()}) {
            robot.cycleMs = cycleMs;
            robot.losesOneSipIn = lost;
            try (Stage stage = Stage.connected(robot, latencyMs)) {
                stage.bot.set("cruiseTurn", cruise);
                double[] covered = {0};
                double seconds = stage.secondsOf(() -> covered[0] = Stage.amount(stage.bot.turn(degrees)));

                System.err.printf("%s %.1f deg at %.0f cyc %d lat %d lost %d: %.2f in %.1f s%n", robot.subclass, degrees, cruise, cycleMs, latencyMs, lost, robot.robot.heading(), seconds);
                assertThat(covered[0]).isCloseTo(degrees, within(1.0));
                assertThat(robot.robot.heading()).isCloseTo(degrees, within(1.5));
            }
        }
    }
}
