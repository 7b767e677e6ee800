package majic.ros;

import static org.assertj.core.api.Assertions.assertThat;

import majic.bot.MajicBot.Connection;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** A server that is stuck for a while: a real one discards what it has not read yet when a connection is closed. */
class StuckServerTest {
    @AutoClose
    private final ScriptedRos robot = new ScriptedRos();

    @BeforeEach
    void loseTheServerInADrive() throws InterruptedException {
        robot.bot().connect();
        robot.bot().drive(100, 0);
        robot.fallSilent();
        for (int step = 0; step < 30 && robot.bot().connection() != Connection.LOST; step++) {
            robot.bot().time().sleep(0.1);
        }
        assertThat(robot.bot().connection()).isEqualTo(Connection.LOST);
    }

    @Test
    void theLastStopWaitsForItOnAnOpenConnection() throws InterruptedException {
        robot.bot().time().sleep(20);

        assertThat(robot.newest().path("op").asText()).isEqualTo("publish");
        assertThat(robot.newest().path("msg").path("linear").path("x").asDouble(1))
                .isZero();
    }

    @Test
    void theConnectionIsClosedOnceItGoesOn() throws InterruptedException {
        robot.bot().time().sleep(3);

        robot.speakAgain();
        robot.bot().time().sleep(1);

        assertThat(robot.newest().path("op").asText()).isEqualTo("close");
    }

    @Test
    void theConnectionIsClosedAfterHalfAMinuteAnyway() throws InterruptedException {
        robot.bot().time().sleep(32);

        assertThat(robot.newest().path("op").asText()).isEqualTo("close");
    }

    @Test
    void theClosedRobotWaitsForNothing() {
        robot.bot().close();

        assertThat(robot.newest().path("op").asText()).isEqualTo("close");
    }
}
