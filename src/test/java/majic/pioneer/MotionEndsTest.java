package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.util.function.Consumer;
import majic.bot.MotionFailed;
import majic.bot.MotionStopped;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** What ends a motion or a drive early. */
class MotionEndsTest {
    private static final int STOP_BUTTON = 1 << 5;
    private static final int E_STALL = 1 << 6;
    private static final int NEAR_LEDGE = 1 << 8;
    private static final int STALLED = 0x0101;
    private static final int FRONT_BUMPER = 0x0200;
    private static final int REAR_BUMPER = 0x0002;

    private final ScriptedPioneer robot = ScriptedPioneer.robot();

    @AutoClose
    private final PioneerRig stage = new PioneerRig(robot);

    private void connect() {
        robot.subclass = "patrolbot-sh";
        robot.answersConfig = false;
        stage.bot.connect();
    }

    private void moveUntil(double mm, Consumer<ScriptedPioneer> event, String reason) {
        connect();
        stage.whenBeyond(50, () -> event.accept(robot));

        assertThatThrownBy(() -> stage.bot.move(mm))
                .isInstanceOf(MotionFailed.class)
                .hasMessageMatching(reason + " after -?\\d+(\\.\\d)? mm");
        stage.line.pass(0.01);
        assertThat(robot.heardLast("STOP 0", "VEL 0", "RVEL 0")).isTrue();
    }

    @Test
    void aStallEndsTheMotionWithTheWayCovered() {
        moveUntil(1000, pioneer -> pioneer.stallBits = STALLED, "stalled");
    }

    @Test
    void theStopButtonEndsTheMotion() {
        moveUntil(1000, pioneer -> pioneer.extraFlags = STOP_BUTTON, "STOP button pressed");
    }

    @Test
    void anEmergencyStopEndsTheMotion() {
        moveUntil(1000, pioneer -> pioneer.extraFlags = E_STALL, "emergency stop engaged");
    }

    @Test
    void motorsSwitchedOffEndTheMotion() {
        moveUntil(1000, pioneer -> pioneer.motors = false, "motors switched off");
    }

    @Test
    void aBumperOnTheWayEndsTheMotion() {
        moveUntil(1000, pioneer -> pioneer.stallBits = FRONT_BUMPER, "front bumper touched");
    }

    @Test
    void theRearBumperEndsTheMotionBackward() {
        moveUntil(-1000, pioneer -> pioneer.stallBits = REAR_BUMPER, "rear bumper touched");
    }

    @Test
    void aBumperBehindDoesNotHinderTheWayAhead() {
        connect();
        stage.whenBeyond(50, () -> robot.stallBits = REAR_BUMPER);

        assertThat(PioneerRig.amount(stage.bot.move(300))).isBetween(290.0, 310.0);
    }

    @Test
    void theDistanceInTheMessageIsThatAtWhichTheRobotComesToRest() {
        connect();
        stage.whenBeyond(300, () -> robot.stallBits = FRONT_BUMPER);

        Throwable failure = catchThrowable(() -> stage.bot.move(2000));
        double x = stage.bot.get("x").number();

        assertThat(failure)
                .hasMessage("front bumper touched after " + Value.of(robot.robot.x(), Unit.MM))
                .hasMessageContaining(Value.of(x, Unit.MM).toString());
        assertThat(x).isGreaterThan(350);
    }

    @Test
    void motorsAreAnnouncedWhenTheRobotReportsThem() {
        connect();
        robot.neverEnables = true;
        Throwable failure = catchThrowable(() -> stage.bot.move(100));
        assertThat(failure).hasMessageContaining("do not switch on");
        assertThatThrownBy(() -> stage.bot.set("motors", "on")).hasMessageContaining("did not switch on");
        assertThat(stage.notices).doesNotContain("motors on");

        robot.neverEnables = false;
        stage.bot.move(100);
        stage.bot.set("motors", "off");
        stage.bot.set("motors", "on");
        stage.line.pass(0.01);

        assertThat(stage.notices).filteredOn("motors on"::equals).hasSize(2);
    }

    @Test
    void aGuardThatHoldsAlreadyLeavesTheMotorsOff() {
        connect();

        assertThat(PioneerRig.amount(stage.bot.move(1000, () -> true))).isZero();
        assertThat(robot.heard).noneMatch(command -> command.startsWith("ENABLE"));
    }

    @Test
    void stopEndsAMotionAndReturnsWhenTheRobotIsStationary() {
        connect();
        boolean[] beyond = {false};
        stage.whenBeyond(50, () -> beyond[0] = true);

        Throwable failure = stage.meanwhile(bot -> bot.move(1000), () -> {
            stage.line.await(() -> beyond[0], 10);
            stage.bot.stop();
            assertThat(robot.robot.isStationary()).isTrue();
        });

        assertThat(failure).isInstanceOf(MotionStopped.class).hasMessage("stopped");
    }

    @Test
    void aStopThatIsNotConfirmedReportsItsTimeout() {
        connect();
        stage.bot.drive(300, 0);
        stage.line.pass(0.5);
        robot.robot.ramps(1, 1);
        robot.ignoresEmergency = true;

        assertThatThrownBy(stage.bot::stop).hasMessageContaining("within 4 s of the stop");
    }

    @Test
    void aRobotThatDoesNotBrakeAsItShouldIsStoppedHard() {
        connect();
        stage.bot.drive(300, 0);
        stage.line.pass(0.5);
        robot.robot.ramps(1, 1);

        stage.bot.stop();

        assertThat(robot.heardLast("STOP 0", "VEL 0", "RVEL 0", "ESTOP 0")).isTrue();
        assertThat(robot.robot.isStationary()).isTrue();
    }

    @Test
    void aStepThatComesInSightEndsTheWayAhead() {
        moveUntil(1000, pioneer -> pioneer.extraFlags = NEAR_LEDGE, "the robot looks down a step");
    }

    @Test
    void aLedgeFlagThatIsAlwaysSetIsIgnored() {
        robot.extraFlags = NEAR_LEDGE;
        connect();

        assertThat(PioneerRig.amount(stage.bot.move(100))).isBetween(90.0, 110.0);
    }

    @Test
    void aTimedDriveWhoseGuardHoldsAlreadyDoesNotBegin() {
        connect();

        stage.bot.drive(200, 0, 2, () -> true);
        stage.line.pass(0.5);

        assertThat(robot.heard).noneMatch(command -> command.matches("(ENABLE|VEL|RVEL) .*"));
    }

    @Test
    void aGuardThatComesTrueWhileTheMotorsSwitchOnMovesNothing() {
        connect();
        robot.neverEnables = true;

        stage.bot.move(1000, () -> robot.heard.contains("ENABLE 1"));
        stage.line.pass(0.3);

        assertThat(robot.heard).contains("ENABLE 1").noneMatch(command -> command.matches("VEL [^0].*"));
    }

    @Test
    void aGuardThatDoesNotReturnDoesNotDriveTheRobotOn() {
        connect();
        boolean[] stood = {false};

        stage.bot.move(600, () -> {
            if (!stood[0] && stage.bot.state().pose().xMm() > 100) {
                stage.line.pass(2);
                stood[0] = robot.robot.isStationary();
            }
            return false;
        });

        assertThat(stood[0]).isTrue();
        assertThat(robot.robot.x()).isBetween(590.0, 610.0);
    }

    @Test
    void aDrivenRobotThatStallsIsStoppedAtOnceWithAReason() {
        connect();
        stage.bot.drive(200, 0);
        stage.line.pass(0.3);
        robot.stallBits = STALLED;
        stage.line.pass(0.11);

        assertThat(robot.heardLast("STOP 0", "VEL 0", "RVEL 0")).isTrue();
        assertThatThrownBy(() -> stage.bot.drive(200, 0))
                .isInstanceOf(MotionFailed.class)
                .hasMessage("stalled");
    }

    @Test
    void theReasonOfADriveThatEndedIsANoticeAtTheStop() {
        connect();
        stage.bot.drive(200, 0);
        stage.line.pass(0.2);
        robot.stallBits = FRONT_BUMPER;
        stage.line.pass(1);

        assertThat(stage.notices).contains("the drive ended: front bumper touched");
    }

    @Test
    void aDriveAwayFromWhatTheBumperTouchesIsPossible() {
        connect();
        robot.stallBits = FRONT_BUMPER;
        stage.bot.drive(-100, 0, 1, () -> false);

        assertThat(robot.robot.x()).isLessThan(-50);
    }

    @Test
    void aTimedDriveFailsWithTheReason() {
        connect();
        stage.whenBeyond(50, () -> robot.extraFlags = STOP_BUTTON);

        assertThatThrownBy(() -> stage.bot.drive(200, 10, 20, () -> false))
                .isInstanceOf(MotionFailed.class)
                .hasMessage("STOP button pressed");
    }

    @Test
    void aDriveEndsIfTheMotorsDoNotSwitchOn() {
        connect();
        robot.neverEnables = true;

        assertThatThrownBy(() -> stage.bot.drive(200, 0, 10, () -> false)).hasMessage("motors do not switch on");
    }
}
