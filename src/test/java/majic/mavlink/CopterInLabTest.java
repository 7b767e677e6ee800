package majic.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import majic.act.Role;
import majic.bot.Guard;
import majic.bot.MajicBot;
import majic.bot.MotionFailed;
import majic.bot.MotionReport;
import majic.bot.Unit;
import majic.bot.Value;
import majic.inlab.LabRig;
import majic.inlab.LabRobot;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** A copter of the simulated lab, which uses no code of the driver, is flown. */
class CopterInLabTest {
    private static final int LOITER = 5;
    private static final int BRAKE = 17;

    @AutoClose
    private final LabRobot robot = new LabRobot("mavlink", LabRig.exactWithMavlink("copter+ready")).at(1200, 0, 0);

    private final MajicBot copter = robot.bot();

    CopterInLabTest() {
        copter.connect();
        pass(2);
    }

    private void fence(double radiusMm) {
        copter.set("fence", List.of(Value.of(radiusMm, Unit.MM), Value.of(1000, Unit.MM), Value.of(5000, Unit.MM)));
    }

    private void flying() {
        fence(4000);
        copter.run("arm", List.of());
        run("takeoff", 2000);
    }

    private void run(String command, double mm) {
        copter.run(command, List.of(Value.of(mm, Unit.MM)));
    }

    private void pass(double seconds) {
        try {
            copter.time().sleep(seconds);
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    private CompletableFuture<MotionReport> aside(double mm) {
        CompletableFuture<MotionReport> motion = new CompletableFuture<>();
        copter.time()
                .thread("move", () -> motion.completeAsync(() -> copter.move(mm), Runnable::run))
                .start();
        return motion;
    }

    private int mode() {
        int[] mode = new int[1];
        robot.besideMavlink(vehicle -> mode[0] = vehicle.mode());
        return mode[0];
    }

    private double heightMm() {
        double[] height = new double[1];
        robot.besideMavlink(vehicle -> height[0] = 1000 * vehicle.heightM());
        return height[0];
    }

    private boolean isArmed() {
        boolean[] armed = new boolean[1];
        robot.besideMavlink(vehicle -> armed[0] = vehicle.isArmed());
        return armed[0];
    }

    private void assertUnharmed() {
        robot.besideMavlink(vehicle -> {
            assertThat(vehicle.crashes()).isZero();
            assertThat(vehicle.disarmsInFlight()).isZero();
        });
    }

    /** Behind the refused motion zero velocities are repeated. */
    @Test
    void itTakesOffThoughAMotionWasRefusedJustBefore() {
        fence(4000);
        copter.run("arm", List.of());
        assertThatThrownBy(() -> copter.move(500)).hasMessageContaining("it is not in the air");

        run("takeoff", 2000);

        assertThat(copter.get("altitude").number()).isCloseTo(2000, within(300.0));
    }

    @Test
    void itTakesOffGoesTurnsClimbsAndLands() {
        flying();
        assertThat(heightMm()).isCloseTo(2000, within(300.0));
        copter.move(2000);
        copter.turn(90);
        run("climb", 1000);
        copter.move(500);
        run("climb", -500);

        assertThat(robot.truePose().xMm()).isCloseTo(3200, within(200.0));
        assertThat(robot.truePose().yMm()).isCloseTo(500, within(200.0));
        assertThat(robot.truePose().headingDeg()).isCloseTo(90, within(4.0));
        assertThat(heightMm()).isCloseTo(2500, within(300.0));

        copter.run("land", List.of());
        pass(20);
        assertThat(heightMm()).isZero();
        assertThat(isArmed()).isFalse();
        assertUnharmed();
    }

    @Test
    void aStopLeavesItHoveringAndArmed() {
        flying();
        CompletableFuture<MotionReport> motion = aside(3500);
        pass(2);

        copter.stop();

        assertThat(mode()).isEqualTo(BRAKE);
        double xMm = robot.truePose().xMm();
        pass(5);
        assertThat(motion).isCompletedExceptionally();
        assertThat(robot.truePose().xMm()).isCloseTo(xMm, within(150.0));
        assertThat(heightMm()).isCloseTo(2000, within(300.0));
        assertThat(isArmed()).isTrue();
        assertThatThrownBy(() -> copter.run("disarm", List.of())).isInstanceOf(MotionFailed.class);
        assertThat(isArmed()).isTrue();
        assertUnharmed();
    }

    @Test
    void aMotionThatEndsOutsideOfTheFenceIsNotBegun() {
        flying();

        assertThatThrownBy(() -> copter.move(4600)).hasMessageContaining("it would end outside of the fence");
        assertThatThrownBy(() -> run("climb", 4000)).hasMessageContaining("and the fence ends at 5000 mm");
        assertThatThrownBy(() -> run("climb", -1500)).hasMessageContaining("and the fence begins at 1000 mm");
        pass(1);
        assertThat(robot.truePose().xMm()).isCloseTo(1200, within(100.0));
    }

    @Test
    void aDriveThatLeavesTheFenceIsBraked() {
        flying();
        fence(2000);

        assertThatThrownBy(() -> copter.drive(1000, 0, 10, Guard.NEVER)).hasMessageContaining("it leaves the fence");
        pass(3);
        assertThat(mode()).isEqualTo(BRAKE);
        assertThat(robot.truePose().xMm()).isBetween(2200.0, 4100.0);
        assertThat(heightMm()).isCloseTo(2000, within(300.0));
        assertUnharmed();
    }

    @Test
    void theRadioPilotTakesItOver() {
        flying();
        CompletableFuture<MotionReport> motion = aside(3500);
        pass(2.5);

        robot.besideMavlink(vehicle -> {
            vehicle.pilotStick(3, 1500);
            vehicle.pilotMode(LOITER);
        });
        pass(8);

        assertThat(motion)
                .failsWithin(Duration.ZERO)
                .withThrowableThat()
                .withMessageContaining("the mode was changed to LOITER by another");
        assertThat(mode()).isEqualTo(LOITER);
        assertThat(isArmed()).isTrue();
        assertUnharmed();
    }

    @Test
    void onTheGroundNothingButATakeOffMovesIt() {
        fence(4000);
        copter.run("arm", List.of());

        assertThatThrownBy(() -> copter.move(1000)).hasMessageContaining("it is not in the air");
        assertThatThrownBy(() -> run("climb", 1000)).hasMessageContaining("it is not in the air");
        assertThatThrownBy(() -> run("takeoff", 9000)).hasMessageContaining("it would end outside of the fence");
        copter.run("disarm", List.of());
        assertThat(isArmed()).isFalse();
    }

    @Test
    void anActForRobotsOnTheGroundDoesNotTakeIt() {
        assertThat(Role.any(Role.ME).unfit(copter))
                .contains("leaves the ground, and the act is for robots on the ground");
        assertThat(Role.any(Role.ME).types("mavlink").unfit(copter)).isPresent();
        assertThat(Role.any(Role.ME).calling("takeoff").unfit(copter)).isEmpty();
    }
}
