package majic.ros;

import static org.assertj.core.api.Assertions.assertThat;

import majic.bot.MajicBot.Connection;
import majic.time.TimeSource;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A server that is stuck for a while: a real one discards what it has not read yet when a connection is closed. */
class StuckServerTest {
    @AutoClose
    private final ScriptedRos robot = new ScriptedRos();

    private void loseTheServerInADrive() throws InterruptedException {
        robot.bot().connect();
        robot.bot().drive(100, 0);
        robot.fallSilent();
        for (int step = 0; step < 30 && robot.bot().connection() != Connection.LOST; step++) {
            robot.bot().time().sleep(0.1);
        }
        assertThat(robot.bot().connection()).isEqualTo(Connection.LOST);
    }

    @ParameterizedTest(name = "after {0} s")
    @ValueSource(doubles = {0.05, 0.33, 0.61, 0.89, 2.17})
    void itIsNoticedWithinASecond(double seconds) throws InterruptedException {
        TimeSource time = robot.bot().time();
        robot.bot().connect();
        robot.bot().drive(100, 0);
        time.sleep(seconds);

        robot.fallSilent();
        long silentNanos = time.nanos();
        while (robot.bot().connection() != Connection.LOST && time.secondsSince(silentNanos) < 3) {
            time.sleep(0.01);
        }

        assertThat(time.secondsSince(silentNanos)).isBetween(0.7, 1.0);
    }

    @Test
    void theLastStopWaitsForItOnAnOpenConnection() throws InterruptedException {
        loseTheServerInADrive();
        robot.bot().time().sleep(20);

        assertThat(robot.newest().path("op").asText()).isEqualTo("publish");
        assertThat(robot.newest().path("msg").path("linear").path("x").asDouble(1))
                .isZero();
    }

    @Test
    void theConnectionIsClosedOnceItGoesOn() throws InterruptedException {
        loseTheServerInADrive();
        robot.bot().time().sleep(3);

        robot.speakAgain();
        robot.bot().time().sleep(1);

        assertThat(robot.newest().path("op").asText()).isEqualTo("close");
    }

    @Test
    void theConnectionIsClosedAfterHalfAMinuteAnyway() throws InterruptedException {
        loseTheServerInADrive();
        robot.bot().time().sleep(32);

        assertThat(robot.newest().path("op").asText()).isEqualTo("close");
    }

    @Test
    void theClosedRobotWaitsForNothing() throws InterruptedException {
        loseTheServerInADrive();

        robot.bot().close();

        assertThat(robot.newest().path("op").asText()).isEqualTo("close");
    }
}
