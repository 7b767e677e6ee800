package majic.pioneer.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majic.bot.Pose;
import majic.pioneer.state.Limits;
import majic.pioneer.state.Models;
import majic.pioneer.state.PioneerState;
import majic.pioneer.state.Ramps;
import majic.pioneer.state.StateTracker;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Controls models of robots with different ramps and latencies, without link or clock. */
class SpeedControllerTest {
    private static final double TICK_S = 0.01;
    private static final int TICKS_PER_SIP = 10;
    private static final Ramps RAMPS = Ramps.careful(Limits.of(Models.USUAL, null));

    @ParameterizedTest(name = "{0} mm with ramps of {1}, {2} mm/s², obeying {3} ms late")
    @CsvSource({
        "1000, 300, 300, 0",
        "-1000, 300, 300, 20",
        "5000, 300, 500, 50",
        "300, 1000, 2000, 0",
        "-700, 200, 200, 50",
        "1000, 300, 150, 20",
        "5, 300, 300, 20",
        "-5, 300, 500, 50",
        "37, 2000, 2000, 100"
    })
    void aMoveEndsStationaryWithinTenMillimetres(double mm, double acceleration, double deceleration, int lateMs) {
        RampModel robot = new RampModel(acceleration, deceleration, 100);

        double seconds = steer(robot, mm, lateMs, true);

        assertThat(robot.x()).isCloseTo(mm, within(10.0));
        assertThat(robot.isStationary()).isTrue();
        assertThat(seconds).isLessThan(Math.abs(mm) / 300 * 2 + 5);
    }

    @ParameterizedTest(name = "{0} deg with ramps of {1} deg/s², obeying {2} ms late")
    @CsvSource({"90, 100, 0", "-90, 100, 50", "540, 100, 20", "-720, 300, 20", "2, 100, 20", "-2, 60, 50", "180, 60, 20"
    })
    void aTurnEndsStationaryWithinADegree(double degrees, double acceleration, int lateMs) {
        RampModel robot = new RampModel(300, 300, acceleration);

        double seconds = steer(robot, degrees, lateMs, false);

        assertThat(robot.heading()).isCloseTo(degrees, within(1.0));
        assertThat(robot.isStationary()).isTrue();
        assertThat(seconds).isLessThan(Math.abs(degrees) / 50 * 2 + 5);
    }

    /**
     * Sends a rate at each SIP, which takes effect some ticks later, until the robot has been stationary for a while.
     */
    private static double steer(RampModel robot, double amount, int lateMs, boolean straight) {
        StateTracker tracker = new StateTracker(Models.of("p3dx-sh"), Pose.START);
        PioneerState start = tracker.track(robot.sip(), 100_000_000L);
        MotionTarget target = straight
                ? new MotionTarget.Straight(start, amount, 300, RAMPS)
                : new MotionTarget.Turning(start, amount, 50, RAMPS);
        SpeedController controller = target.controller();
        int stationary = 0;
        int sips = 1;
        while (stationary < 3 && sips < 600) {
            PioneerState now = tracker.track(robot.sip(), ++sips * 100_000_000L);
            controller.reported(target.covered(now), now.isMoving(), sips / 10.0);
            double rate = controller.next(target.covered(now), target.rate(now), sips / 10.0, 0.1);
            stationary = rate == 0 && robot.isStationary() ? stationary + 1 : 0;
            for (int tick = 0; tick < TICKS_PER_SIP; tick++) {
                if (tick * TICK_S * 1000 >= Math.min(lateMs, 90)) {
                    follow(robot, (int) Math.round(rate), straight);
                }
                robot.step(TICK_S);
            }
        }
        return sips / 10.0;
    }

    private static void follow(RampModel robot, int rate, boolean straight) {
        if (straight) {
            robot.speed(rate);
        } else {
            robot.rate(rate);
        }
    }
}
