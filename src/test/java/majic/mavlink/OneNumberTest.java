package majic.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import majic.bot.BotException;
import majic.bot.MotionFailed;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Two vehicles with one number behind one address: both get what is sent, and the messages of both arrive. */
class OneNumberTest {
    private static final String FOUND = "two vehicles send with the number 1 from one address";

    @AutoClose
    private final DrivenRover robot = new DrivenRover();

    private final ScriptedRover rover = robot.rover;
    private final MajicMavlink bot = robot.bot();
    private final ScriptedRover other = new ScriptedRover(robot.peer::send);

    private void addOther() {
        other.ranMs += (int) robot.peer.millis();
        other.armed = true;
        other.mode = ScriptedRover.GUIDED;
        robot.others.add(other);
    }

    private long noticesWith(String text) {
        return robot.notices().stream().filter(notice -> notice.contains(text)).count();
    }

    @Test
    void aSecondVehicleWhoseClockContradictsIsSaidOnceAndIsNoRestart() {
        robot.ready();
        other.ranMs = 100_000;
        addOther();
        robot.pass(20);

        assertThat(noticesWith(FOUND)).isEqualTo(1);
        assertThat(noticesWith("has restarted")).isLessThanOrEqualTo(1);
        assertThat(bot.isConnected()).isTrue();
    }

    @Test
    void aSecondVehicleOfAnotherKindIsSaid() {
        robot.ready();
        other.type = 11;
        addOther();
        robot.pass(5);

        assertThat(noticesWith(FOUND)).isEqualTo(1);
        assertThat(noticesWith("has restarted")).isZero();
    }

    @Test
    void twoRestartsAreNoSecondVehicle() {
        robot.ready();
        robot.pass(5);
        rover.restart();
        robot.pass(4);
        rover.restart();
        robot.pass(4);

        assertThat(noticesWith(FOUND)).isZero();
        assertThat(noticesWith("has restarted")).isEqualTo(2);
    }

    /** As vehicles that are made with MAVSDK. */
    @Test
    void anotherClockForEachKindOfReportIsNoSecondVehicleAndNoRestart() {
        rover.positionLagMs = 100_000;
        robot.ready();
        robot.pass(5);

        assertThat(noticesWith(FOUND)).isZero();
        assertThat(noticesWith("has restarted")).isZero();
    }

    @Test
    void aMotionEndsWithThatReasonAndBothAreStopped() {
        robot.ready();
        CompletableFuture<?> moving = robot.clock().aside(() -> bot.move(5000));
        robot.pass(2);
        other.ranMs = 100_000;
        addOther();

        assertThatThrownBy(() -> robot.clock().join(moving)).hasMessageContaining(FOUND);
        robot.pass(2);
        assertThat(rover.mode).isEqualTo(ScriptedRover.HOLD);
        assertThat(other.mode).isEqualTo(ScriptedRover.HOLD);
    }

    @Test
    void neitherIsMovedOrArmedAndAStopGoesToBothWithoutBeingConfirmed() {
        robot.ready();
        other.ranMs = 100_000;
        addOther();
        robot.pass(5);
        rover.mode = ScriptedRover.GUIDED;
        int targets = rover.targets().size();

        for (Runnable moves : List.<Runnable>of(
                () -> bot.move(1000),
                () -> bot.turn(90),
                () -> bot.drive(100, 0),
                () -> bot.run("arm", List.of()),
                () -> bot.run("gotoGlobal", List.of(Value.of(47, Unit.LAT_LON), Value.of(9, Unit.LAT_LON))),
                () -> bot.set("mode", "AUTO"))) {
            assertThatThrownBy(moves::run).isInstanceOf(MotionFailed.class).hasMessageContaining(FOUND);
        }
        assertThat(rover.targets()).hasSize(targets);

        assertThatThrownBy(bot::stop)
                .isInstanceOf(BotException.class)
                .hasMessageContaining("has the number of another vehicle");
        robot.pass(1);
        assertThat(rover.mode).isEqualTo(ScriptedRover.HOLD);
        assertThat(other.mode).isEqualTo(ScriptedRover.HOLD);
    }
}
