package majic.ros;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import majic.bot.BotListener;
import majic.bot.MajicBot;
import majic.bot.MotionFailed;
import majic.bot.Pose;
import majic.inlab.LabRig;
import majic.inlab.LabRobot;
import majicsim.ros.RosHandling;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Motions of the simulated robot while the robot or its computer has a fault. */
class RosFaultsInMotionTest {
    @AutoClose
    private final LabRobot robot = new LabRobot("ros", LabRig.exactWithRos("2")).at(1000, 0, 0);

    private final MajicBot bot = robot.bot();

    /** Orders a fault as soon as the robot has covered 200 mm of the next motion. */
    private void after200Mm(Consumer<RosHandling> fault) {
        Pose start = robot.truePose();
        Runnable wait = () -> {
            while (robot.truePose().distanceMm(start) < 200) {
                pass(0.02);
            }
            robot.besideRos(fault);
        };
        bot.time().thread("fault", wait).start();
    }

    @Test
    void aMotionWhoseOdometryStopsEndsAndTheRobotStops() {
        bot.connect();
        after200Mm(ros -> ros.silence("/odom", true));

        assertThatThrownBy(() -> bot.move(1000))
                .isInstanceOf(MotionFailed.class)
                .hasMessageMatching("its odometry has been silent for 1 s after (19|20|21)\\d mm");

        pass(0.3);
        Pose stopped = robot.truePose();
        pass(1);
        assertThat(robot.truePose()).isEqualTo(stopped);
        assertThatThrownBy(bot::stop).hasMessageContaining("has been silent");
    }

    @ParameterizedTest(name = "by {0} s")
    @ValueSource(doubles = {3600, -3600, 0.5, -0.5})
    void aJumpOfTheRobotsClockChangesNothing(double seconds) {
        bot.connect();
        after200Mm(ros -> ros.jumpClock(seconds));

        bot.move(600);

        assertThat(robot.truePose().xMm()).isCloseTo(1600, within(10.0));
    }

    @ParameterizedTest(name = "{0} Hz")
    @ValueSource(doubles = {5, 1000})
    void anOdometryOfAnotherRateIsFollowed(double hertz) {
        robot.besideRos(ros -> ros.rate("/odom", hertz));
        bot.connect();

        bot.move(500);
        bot.turn(90);

        assertThat(robot.truePose().xMm()).isCloseTo(1500, within(10.0));
        assertThat(robot.truePose().headingDeg()).isCloseTo(90, within(1.0));
    }

    @Test
    void messagesThatAreNoJsonAreLeftOut() {
        bot.connect();
        after200Mm(ros -> ros.malform(10));

        bot.move(500);

        assertThat(robot.truePose().xMm()).isCloseTo(1500, within(10.0));
    }

    /**
     * On ROS 2 the robot cuts velocities to steps of 0.01 m/s and 0.01 rad/s, which the calculation does not include.
     */
    @Test
    void aRobotWithoutOdometryIsMovedByCalculation() {
        List<String> notices = new CopyOnWriteArrayList<>();
        bot.addListener(new BotListener() {
            @Override
            public void notice(MajicBot from, String message) {
                notices.add(message);
            }
        });
        robot.besideRos(ros -> ros.hideTopics("/odom"));
        bot.connect();
        pass(0.1);
        assertThat(notices).anyMatch(notice -> notice.contains("nothing confirms that a stop has stopped it"));

        assertThat(bot.profile().estimates()).isTrue();
        bot.move(500);
        bot.turn(90);

        assertThat(robot.truePose().xMm()).isCloseTo(1500, within(25.0));
        assertThat(robot.truePose().headingDeg()).isCloseTo(90, within(3.0));
        assertThat(bot.state().pose().xMm()).isCloseTo(500, within(2.0));
        bot.stop();
    }

    @Test
    void aBridgeThatAnswersNoServicesAnyMoreStillStopsTheRobot() {
        bot.connect();
        robot.besideRos(ros -> ros.suppressServices(true));
        bot.drive(200, 0);
        pass(0.5);

        bot.stop();

        Pose stopped = robot.truePose();
        pass(1);
        assertThat(robot.truePose()).isEqualTo(stopped);
    }

    private void pass(double seconds) {
        try {
            bot.time().sleep(seconds);
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }
}
