package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.stream.IntStream;
import majic.bot.LinkLost;
import majic.bot.MajicBot;
import majic.bot.MotionFailed;
import majic.pioneer.arcos.Bytes;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** What is sent, and when, while the robot reports nothing or the driver has no commands. */
class HeartbeatTest {
    private final ScriptedPioneer robot = ScriptedPioneer.robot();

    @AutoClose
    private final PioneerRig stage = PioneerRig.connected(robot);

    @Test
    void noTwoPacketsAreEverHalfASecondApart() {
        stage.line.pass(20);
        stage.bot.turn(90);
        stage.bot.move(300);
        stage.line.pass(20);

        List<Long> times = List.copyOf(robot.heardAt).subList(robot.heard.indexOf("OPEN 1"), robot.heardAt.size());
        assertThat(IntStream.range(1, times.size()).mapToObj(index -> times.get(index) - times.get(index - 1)))
                .allMatch(pause -> pause <= 400);
        assertThat(robot.heard).contains("PULSE 0");
    }

    @Test
    void pulsesGoOnWhileAMotionWaitsForASlowRobot() {
        robot.cycleMs = 450;

        stage.bot.turn(30);

        assertThat(robot.heard).contains("PULSE 0");
    }

    @Test
    void aMovingRobotThatStopsReportingIsSentZeroAndThenNothing() {
        long[] silentMs = {0};
        stage.whenBeyond(100, () -> {
            robot.silent = true;
            silentMs[0] = stage.line.millis();
        });

        assertThatThrownBy(() -> stage.bot.move(1000))
                .isInstanceOf(LinkLost.class)
                .hasMessage("connection lost: the robot has been silent for 1 s");
        stage.line.pass(5);

        assertThat(robot.heardLast("VEL 0", "RVEL 0")).isTrue();
        assertThat(robot.heard).last().isEqualTo("RVEL 0");
        assertThat(robot.heardAt.get(robot.heardAt.size() - 1) - silentMs[0]).isBetween(500L, 620L);
        // The clock waits for bytes but not for the end of a link, which may be noticed a cycle or two later.
        assertThat(stage.line.endMs - silentMs[0]).isBetween(1000L, 1350L);
        assertThat(stage.line.endedHard).isTrue();
    }

    @Test
    void aDrivenRobotThatStopsReportingIsStoppedAndNotDrivenOn() {
        stage.bot.drive(200, 0);
        stage.line.pass(0.4);
        robot.silent = true;
        stage.bot.drive(200, 0);
        stage.line.pass(0.55);

        assertThatThrownBy(() -> stage.bot.drive(200, 0))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("fell silent");
        stage.line.pass(0.02);
        assertThat(robot.heard.stream().filter(order -> order.startsWith("VEL")))
                .last()
                .isEqualTo("VEL 0");
    }

    @Test
    void anOutageDeliveredAtOnceEndsTheMotionAndNothingResumes() {
        stage.whenBeyond(100, () -> stage.line.hold(0.7));

        assertThatThrownBy(() -> stage.bot.move(3000)).hasMessageStartingWith("the robot fell silent after");
        stage.line.pass(3);

        assertThat(robot.robot.isStationary()).isTrue();
        assertThat(stage.bot.isConnected()).isTrue();
        assertThat(PioneerRig.amount(stage.bot.move(100))).isBetween(90.0, 110.0);
    }

    @Test
    void aStationaryRobotIsGivenMoreTime() {
        robot.silent = true;
        stage.line.pass(2.8);
        assertThat(stage.bot.isConnected()).isTrue();

        stage.line.pass(0.4);

        assertThat(stage.bot.connection()).isEqualTo(MajicBot.Connection.LOST);
    }

    @Test
    void aControllerThatWasResetIsALostConnection() {
        stage.line.send(Bytes.wire(0xFE, new byte[0]));
        stage.line.pass(0.1);

        assertThatThrownBy(() -> stage.bot.move(100)).hasMessage("connection lost: the robot's controller was reset");
    }

    @Test
    void afterALostLinkNothingResumesByItself() {
        stage.whenBeyond(100, () -> robot.silent = true);
        assertThatThrownBy(() -> stage.bot.move(1000)).isInstanceOf(LinkLost.class);
        robot.heard.clear();

        stage.bot.connect();
        stage.line.pass(5);

        assertThat(robot.heard).noneMatch(order -> order.matches("(ENABLE|VEL|RVEL) .*"));
        assertThat(robot.robot.isStationary()).isTrue();
    }

    @Test
    void aStopWithoutAnAnswerReportsTheLostLinkAndNotATimeout() {
        stage.bot.drive(200, 0);
        stage.line.pass(0.4);
        robot.silent = true;

        double seconds = stage.secondsOf(() ->
                assertThatThrownBy(stage.bot::stop).isInstanceOf(LinkLost.class).hasMessageContaining("silent"));
        assertThat(seconds).isLessThan(1.2);
    }
}
