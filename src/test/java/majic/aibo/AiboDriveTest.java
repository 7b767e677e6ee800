package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import majic.bot.Guard;
import majic.bot.MotionFailed;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Walks and drives that something else ends, and a hand that changes its mind. */
class AiboDriveTest {
    @AutoClose
    private final DrivenAibo driven = DrivenAibo.standing().connected();

    private final ScriptedDog dog = driven.dog;
    private final MajicAibo aibo = driven.aibo;

    @Test
    void aNewGaitWaitsForTheEndOfTheOldOne() {
        aibo.drive(60, 0);
        dog.awaitReceived("robot.walk(");

        driveUntilReceived(0, 30, "robot.turn(");

        assertThat(dog.received("stop walk")).isNotEmpty();
        assertThat(dog.mostAtOnce()).isEqualTo(1);
        assertThat(driven.notices)
                .containsSubsequence("drives with its gait straight forward", "drives with its gait on the spot left");
    }

    @Test
    void aDriveWhoseGaitTheStickDoesNotHaveEnds() {
        dog.knowsNo = "robot.walk";

        assertThatThrownBy(() -> driveUntilReceived(60, 0, "never"))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("no such gait");
        assertThat(dog.received("robot.walk(")).hasSize(1);
    }

    @Test
    void aDriveDoesNotSwitchMotorsOnAgainThatWereSwitchedOff() {
        aibo.drive(60, 0);
        dog.awaitReceived("robot.walk(");
        dog.set("legLF1.load", "0.000000");

        assertThatThrownBy(() -> driveUntilReceived(60, 0, "motors on"))
                .isInstanceOf(MotionFailed.class)
                .hasMessage("the dog's motors were switched off");
    }

    @Test
    void aDriveThatWasRenewedTooLateDoesNotGoOn() {
        AtomicInteger walks = new AtomicInteger();
        Guard slow = () -> {
            if (dog.isWalking()) {
                walks.set(dog.received("robot.walk(").size());
                standStill(1.3);
            }
            return false;
        };

        assertThatThrownBy(() -> aibo.drive(60, 0, 40, slow))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("not renewed in time");
        assertThat(dog.received("robot.walk(").size()).isLessThanOrEqualTo(walks.get() + 1);
        assertThat(dog.isWalking()).isFalse();
    }

    @Test
    void aTimedDriveThatGoesWrongAfterItsLastRenewalIsNotDone() {
        CompletableFuture<Void> drive = driven.aside(() -> aibo.drive(60, 0, 0.29, Guard.NEVER));
        driven.until(dog::isWalking);

        dog.endWalk();

        assertThatThrownBy(() -> driven.join(drive)).hasMessageContaining("ended the walk");
    }

    private void standStill(double seconds) {
        try {
            aibo.time().sleep(seconds);
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    @Test
    void aWalkThatAnotherProgramEndsDoesNotGoOn() {
        CompletableFuture<Void> walk = driven.aside(() -> aibo.move(1000));
        driven.until(dog::isWalking);

        dog.endWalk();

        assertThatThrownBy(() -> driven.join(walk))
                .hasMessageContaining("another program, or its guard, ended the walk, after about");
        assertThat(dog.received("robot.walk(")).hasSize(1);
    }

    @Test
    void aStoppedCalibrationStoresNothing() {
        CompletableFuture<Void> calibration = driven.aside(() -> calibrate("forward"));
        dog.awaitReceived("robot.walk(");

        aibo.stop();

        assertThatThrownBy(() -> driven.join(calibration)).hasMessageContaining("stopped");
        assertThatThrownBy(() -> calibrate("forward", Value.of(900, Unit.MM))).hasMessageContaining("moves it first");
        assertThat(aibo.get("forwardFactor").number()).isEqualTo(12);
    }

    private void calibrate(String direction, Value... measured) {
        List<Value> arguments = new ArrayList<>(List.of(measured));
        arguments.add(0, Value.text(direction));
        aibo.run("calibrate", arguments);
    }

    private void driveUntilReceived(double mmPerSec, double degPerSec, String word) {
        driven.until(() -> {
            aibo.drive(mmPerSec, degPerSec);
            return !dog.received(word).isEmpty();
        });
    }
}
