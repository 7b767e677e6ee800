package majic.ros;

import static org.assertj.core.api.Assertions.assertThat;

import majic.bot.Pose;
import majic.inlab.LabRig;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** A ROS robot in MAJIC Script. */
class RosScriptTest {
    @AutoClose
    private final LabRig lab = LabRig.exactWithRos("1");

    @BeforeEach
    void add() {
        lab.add("ros");
    }

    @Test
    void aFieldOfATopicIsAParameterOfALine() throws InterruptedException {
        assertThat(lab.run("1 get topic/scan/range_max, topic/odom/pose/pose/position/x"))
                .containsExactly("1 topic/scan/range_max = 3.5", "1 topic/odom/pose/pose/position/x = 0");
        assertThat(lab.run("1 get topic/scam/range_max"))
                .containsExactly("scam/range_max: the robot has no such topic; did you mean scan?");
    }

    @Test
    void aFieldOfATopicIsAGuard() throws InterruptedException {
        Pose start = lab.truePose("ros");

        lab.run("1 drive 100 0 until topic/odom/pose/pose/position/x > 0.2");

        assertThat(lab.truePose("ros").distanceMm(start)).isBetween(200.0, 260.0);
    }

    @Test
    void gotoTakesUnitsAndAnOptionalHeading() throws InterruptedException {
        assertThat(lab.run("1 goto 0.5m 100mm 90"))
                .singleElement()
                .asString()
                .matches("1 goto 0.5m 100mm 90: done \\([45]\\d\\d mm, .* mm, .* deg; .* s\\)");
        assertThat(lab.run("1 goto 0.5m")).containsExactly("behind \"0.5m\" a distance (mm, cm, m) is missing");
    }

    @Test
    void aConditionEndsAGotoOfTheRobotsOwnNavigation() throws InterruptedException {
        Pose start = lab.truePose("ros");

        assertThat(lab.run("1 goto 2m 0 until x > 300"))
                .singleElement()
                .asString()
                .startsWith("1 goto 2m 0 until x > 300: done (");
        assertThat(lab.truePose("ros").distanceMm(start)).isBetween(250.0, 600.0);
    }

    @Test
    void servicesAreCalledWithArgumentsInQuotes() throws InterruptedException {
        assertThat(lab.run("1 call \"/rosapi/topic_type\" \"topic=/scan\""))
                .containsExactly("1 call \"/rosapi/topic_type\" \"topic=/scan\": type: sensor_msgs/LaserScan");
        assertThat(lab.run("1 call rosapi/topic_type \"{topic: '/odom'}\""))
                .singleElement()
                .asString()
                .endsWith("type: nav_msgs/Odometry");
    }

    @Test
    void whatBeamsWithoutAnEchoMeanIsASetting() throws InterruptedException {
        assertThat(lab.run("1 set noEcho clear", "1 get noEcho"))
                .containsExactly("1 set noEcho clear: done", "1 noEcho = clear");
    }

    @Test
    void theShippedWanderRunsOnARosRobot() throws InterruptedException {
        Pose before = lab.truePose("ros");
        double wayMm = 0;
        double leastMm = Double.POSITIVE_INFINITY;

        lab.say("1 act PioneerWander");
        for (int step = 0; step < 600; step++) {
            lab.team().member(1).bot().time().sleep(0.1);
            Pose now = lab.truePose("ros");
            wayMm += now.distanceMm(before);
            before = now;
            leastMm = Math.min(
                    leastMm, lab.team().member(1).bot().get("scanNearest").number());
        }

        assertThat(lab.said()).noneMatch(line -> line.contains("unknown"));
        assertThat(wayMm).isGreaterThan(2000);
        assertThat(leastMm).isGreaterThan(105);
    }
}
