package majic.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import majic.bot.BotException;
import majic.bot.MotionReport;
import majic.bot.MotionStopped;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The stop of vehicles: its mode at once, repeated, confirmed, and never a command that stops motors. */
class VehicleStopTest {
    private static final int LOITER = 5;

    @AutoClose
    private final DrivenRover robot = new DrivenRover();

    private final ScriptedRover rover = robot.rover;
    private final MajicMavlink bot = robot.bot();

    private CompletableFuture<MotionReport> moving() {
        CompletableFuture<MotionReport> motion = robot.clock().aside(() -> bot.move(5000));
        robot.clock().until(() -> rover.mmPerSec() > 300 || motion.isDone());
        return motion;
    }

    @Test
    void holdAndAZeroVelocityAreTheNextThingsThatAreSent() {
        robot.ready();
        CompletableFuture<MotionReport> motion = moving();
        int before = rover.received.size();

        bot.stop();

        List<VehicleFrames.Got> sent = rover.received.subList(before, rover.received.size());
        assertThat(sent.get(0).id()).isEqualTo(76);
        assertThat(sent.get(0).u16(28)).isEqualTo(176);
        assertThat(sent.get(0).f32(4)).isEqualTo(ScriptedRover.HOLD);
        assertThat(sent.get(1).id()).isEqualTo(84);
        assertThat(sent.get(1).f32(16)).isZero();
        assertThat(sent).filteredOn(got -> got.id() == 84).allMatch(got -> got.f32(16) == 0 && got.f32(44) == 0);
        assertThat(rover.mode).isEqualTo(ScriptedRover.HOLD);
        assertThat(rover.mmPerSec()).isLessThan(20);
        assertThatThrownBy(() -> robot.clock().join(motion)).hasCauseInstanceOf(MotionStopped.class);
    }

    @Test
    void theStopIsRepeatedUntilItIsShownAndThenNoMore() {
        robot.ready();
        moving();
        rover.ignoresModes = true;
        long stoppedMs = robot.peer.millis();
        CompletableFuture<Void> stop = robot.clock().aside(bot::stop);
        robot.pass(1);
        int repeated = rover.commands(176).size();
        rover.ignoresModes = false;
        robot.clock().join(stop);
        robot.pass(0.3);
        int shown = rover.commands(176).size();
        robot.pass(3);

        assertThat(repeated).isGreaterThanOrEqualTo(10);
        assertThat(rover.commands(176)).hasSize(shown);
        assertThat(robot.peer.millis() - stoppedMs).isGreaterThan(1000);
    }

    /** LOITER needs a position. */
    @Test
    void aBoatThatCannotKeepItsPlaceIsStoppedByHold() {
        rover.type = 11;
        robot.ready();
        moving();
        rover.refusedMode = LOITER;
        robot.pass(2);

        bot.stop();

        assertThat(rover.mode).isEqualTo(ScriptedRover.HOLD);
        assertThat(rover.commands(176)).anyMatch(got -> got.f32(4) == LOITER);
        robot.pass(0.5);
        int stops = rover.commands(176).size();
        robot.pass(3);
        assertThat(rover.commands(176)).hasSize(stops);
    }

    @Test
    void aStopThatIsRefusedIsSaid() {
        robot.ready();
        moving();
        rover.modeRefusal = "Mode change refused";

        assertThatThrownBy(bot::stop)
                .isInstanceOf(BotException.class)
                .hasMessageContaining("refuses HOLD: Mode change refused");
    }

    @Test
    void aMotionAfterAStopSetsGuidedAgain() {
        robot.ready();
        moving();
        bot.stop();

        bot.move(1000);

        assertThat(rover.mode).isEqualTo(ScriptedRover.GUIDED);
        robot.pass(2);
        assertThat(rover.mode).isEqualTo(ScriptedRover.GUIDED);
    }

    @Test
    void aStopOfARoverThatOthersDriveHoldsItToo() {
        robot.ready();
        rover.changeMode(10);
        robot.pass(1);

        bot.stop();

        assertThat(rover.mode).isEqualTo(ScriptedRover.HOLD);
    }

    @ParameterizedTest
    @CsvSource({"10, 3, 4", "11, 3, 5", "2, 3, 17", "13, 3, 17", "12, 3, 16", "1, 3, 12"})
    void eachKindOfVehicleHasItsOwnStop(int type, int autopilot, int mode) {
        rover.type = type;
        rover.autopilot = autopilot;
        robot.ready();

        bot.stop();

        assertThat(rover.mode).isEqualTo(mode);
        assertThat(rover.commands(400)).isEmpty();
        assertThat(rover.commands(185)).isEmpty();
        assertThat(rover.armed).isTrue();
    }

    @Test
    void px4IsStoppedByItsHold() {
        rover.autopilot = 12;
        robot.ready();
        CompletableFuture<Void> stop = robot.clock().aside(bot::stop);
        robot.pass(0.5);

        VehicleFrames.Got sent = rover.commands(176).get(0);
        assertThat(sent.f32(0)).isEqualTo(1);
        assertThat(sent.f32(4)).isEqualTo(4);
        assertThat(sent.f32(8)).isEqualTo(3);
        robot.clock().until(stop::isDone);
    }

    @Test
    void closingHoldsARoverThatMajicDrives() {
        robot.ready();
        bot.move(500);

        bot.close();
        robot.pass(0.5);

        assertThat(rover.mode).isEqualTo(ScriptedRover.HOLD);
    }

    @Test
    void closingLeavesAnAircraftToWhomeverFliesIt() {
        rover.type = 2;
        robot.ready();
        rover.changeMode(3);
        robot.pass(1.1);

        bot.close();
        robot.pass(0.5);

        assertThat(rover.mode).isEqualTo(3);
    }
}
