package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import majic.bot.MotionFailed;
import majic.bot.MotionStopped;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Postures, and a dog that must not fall when its motors go off. */
@Timeout(30)
class PostureControlTest {
    @AutoClose
    private Dogs dogs;

    @BeforeEach
    void connect() throws IOException {
        dogs = new Dogs();
        dogs.aibo.connect();
    }

    @Test
    void motorsOffLaysTheDogDownFirst() {
        motorsOff();

        assertThat(poses())
                .satisfiesExactly(
                        lay -> assertThat(lay).endsWith("+end: robot.lay()"),
                        off -> assertThat(off).endsWith("+end: { motors off }"));
        assertThat(dogs.aibo.get("motors").isYes()).isFalse();
    }

    @Test
    void aDogThatLiesOrHasFallenJustGoesLoose() {
        dogs.dog.set("robot.MyguessPosition()", "\"side\"");

        motorsOff();

        assertThat(poses()).singleElement().asString().endsWith("{ motors off }");
    }

    @Test
    void motorsStayOnWhenTheDogCannotLieDownUntilASecondRequest() {
        dogs.dog.knowsNo = "robot.lay";

        assertThatThrownBy(() -> motorsOff())
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("robot.lay")
                .hasMessageEndingWith("ask once more and they go off all the same");
        assertThat(dogs.dog.received("motors off")).isEmpty();

        motorsOff();
        assertThat(dogs.dog.received("motors off")).hasSize(1);
    }

    @Test
    void aDogThatCannotTellThatItLiesGoesLoose() {
        dogs.dog.guessOnceDown = "unknown";

        motorsOff();

        assertThat(dogs.dog.received("motors off")).hasSize(1);
        assertThat(dogs.aibo.get("motors").isYes()).isFalse();
    }

    @Test
    void motorsStayOnWhenTheDogDidNotLieDown() {
        dogs.dog.staysUp = true;

        assertThatThrownBy(() -> motorsOff()).hasMessageContaining("in posture stand");
        assertThat(dogs.dog.received("motors off")).isEmpty();
    }

    @Test
    void motorsStayOnWhenLyingDownWasStopped() {
        dogs.dog.lastingMs = 3000;
        CompletableFuture<Void> off = dogs.aside(() -> motorsOff());
        dogs.dog.awaitReceived("robot.lay");

        dogs.aibo.stop();

        assertThatThrownBy(() -> dogs.join(off)).hasCauseInstanceOf(MotionStopped.class);
        assertThat(dogs.dog.received("motors off")).isEmpty();
    }

    @Test
    void aPostureIsTakenByTheFunctionOfTheStick() {
        dogs.aibo.set("posture", "sit");

        assertThat(poses()).singleElement().asString().endsWith("+end: robot.sit()");
        assertThat(dogs.aibo.parameter("posture").moves()).isTrue();
    }

    @Test
    void aPostureTheStickDoesNotKnowIsSaidSo() {
        dogs.dog.knowsNo = "robot.beg";

        assertThatThrownBy(() -> dogs.aibo.set("posture", "beg")).hasMessageContaining("the dog refuses");
    }

    @Test
    void whatGoesWrongInsideOfGettingUpIsHeard() {
        dogs.dog.set("robot.MyguessPosition()", "\"lay\"");
        dogs.dog.set("legLF1.load", "0.000000");
        dogs.until(() -> !dogs.aibo.get("motors").isYes());

        dogs.aibo.move(5);

        assertThat(dogs.dog.received("motors on"))
                .singleElement()
                .asString()
                .matches("(\\w+)\\+end: \\{ motors on; wait\\(1000\\); \\1: robot.stand\\(\\) }");
    }

    private void motorsOff() {
        dogs.aibo.set("motors", List.of(Value.yesNo(false)));
    }

    private List<String> poses() {
        return dogs.dog.received("+end: ");
    }
}
