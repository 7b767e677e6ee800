package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import majic.bot.Guard;
import majic.bot.MotionFailed;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Walks and drives that something else ends, and a hand that changes its mind. */
@Timeout(30)
class AiboDriveTest {
    @AutoClose
    private Dogs dogs;

    @BeforeEach
    void connect() throws IOException {
        dogs = new Dogs();
        dogs.aibo.connect();
    }

    @Test
    void aNewGaitWaitsForTheEndOfTheOldOne() {
        dogs.aibo.drive(60, 0);
        dogs.dog.awaitReceived("robot.walk(");

        driveUntilReceived(0, 30, "robot.turn(");

        assertThat(dogs.dog.received("stop walk")).isNotEmpty();
        assertThat(dogs.dog.mostAtOnce()).isEqualTo(1);
        assertThat(dogs.notices)
                .containsSubsequence("drives with its gait straight forward", "drives with its gait on the spot left");
    }

    @Test
    void aDriveWhoseGaitTheStickDoesNotHaveEnds() {
        dogs.dog.knowsNo = "robot.walk";

        assertThatThrownBy(() -> driveUntilReceived(60, 0, "never"))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("no such gait");
        assertThat(dogs.dog.received("robot.walk(")).hasSize(1);
    }

    @Test
    void aDriveDoesNotSwitchMotorsOnAgainThatWereSwitchedOff() {
        dogs.aibo.drive(60, 0);
        dogs.dog.awaitReceived("robot.walk(");
        dogs.dog.set("legLF1.load", "0.000000");

        assertThatThrownBy(() -> driveUntilReceived(60, 0, "motors on"))
                .isInstanceOf(MotionFailed.class)
                .hasMessage("the dog's motors were switched off");
    }

    @Test
    void aDriveThatWasRenewedTooLateDoesNotGoOn() {
        AtomicInteger walks = new AtomicInteger();
        Guard slow = () -> {
            if (dogs.dog.isWalking()) {
                walks.set(dogs.dog.received("robot.walk(").size());
                standStill(1.3);
            }
            return false;
        };

        assertThatThrownBy(() -> dogs.aibo.drive(60, 0, 40, slow))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("not renewed in time");
        assertThat(dogs.dog.received("robot.walk(").size()).isLessThanOrEqualTo(walks.get() + 1);
        assertThat(dogs.dog.isWalking()).isFalse();
    }

    private void standStill(double seconds) {
        try {
            dogs.aibo.time().sleep(seconds);
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    @Test
    void aWalkThatAnotherProgramEndsDoesNotGoOn() {
        CompletableFuture<Void> walk = dogs.aside(() -> dogs.aibo.move(1000));
        dogs.until(dogs.dog::isWalking);

        dogs.dog.endWalk();

        assertThatThrownBy(() -> dogs.join(walk))
                .hasMessageContaining("another program, or its guard, ended the walk, after about");
        assertThat(dogs.dog.received("robot.walk(")).hasSize(1);
    }

    @Test
    void aStoppedCalibrationTeachesNothing() {
        CompletableFuture<Void> lesson = dogs.aside(() -> calibrate("forward"));
        dogs.dog.awaitReceived("robot.walk(");

        dogs.aibo.stop();

        assertThatThrownBy(() -> dogs.join(lesson)).hasMessageContaining("stopped");
        assertThatThrownBy(() -> calibrate("forward", Value.of(900, Unit.MM))).hasMessageContaining("moves it first");
        assertThat(dogs.aibo.get("forwardFactor").number()).isEqualTo(12);
    }

    private void calibrate(String direction, Value... measured) {
        List<Value> arguments = new ArrayList<>(List.of(measured));
        arguments.add(0, Value.text(direction));
        dogs.aibo.run("calibrate", arguments);
    }

    private void driveUntilReceived(double mmPerSec, double degPerSec, String word) {
        dogs.until(() -> {
            dogs.aibo.drive(mmPerSec, degPerSec);
            return !dogs.dog.received(word).isEmpty();
        });
    }
}
