package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import majic.bot.MotionFailed;
import majic.bot.MotionStopped;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Postures, and a dog that must not fall when its motors go off. */
class PostureControlTest {
    @AutoClose
    private final DrivenAibo driven = DrivenAibo.standing().connected();

    private final ScriptedDog dog = driven.dog;
    private final MajicAibo aibo = driven.aibo;

    @Test
    void motorsOffLaysTheDogDownFirst() {
        motorsOff();

        assertThat(poses())
                .satisfiesExactly(
                        lay -> assertThat(lay).endsWith("+end: robot.lay()"),
                        off -> assertThat(off).endsWith("+end: { motors off }"));
        assertThat(aibo.get("motors").isYes()).isFalse();
    }

    @Test
    void theMotorsOfALyingOrFallenDogAreSwitchedOffAtOnce() {
        dog.set("robot.MyguessPosition()", "\"side\"");

        motorsOff();

        assertThat(poses()).singleElement().asString().endsWith("{ motors off }");
    }

    @Test
    void motorsStayOnWhenTheDogCannotLieDownUntilASecondRequest() {
        dog.knowsNo = "robot.lay";

        assertThatThrownBy(() -> motorsOff())
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("robot.lay")
                .hasMessageEndingWith("ask once more and they go off all the same");
        assertThat(dog.received("motors off")).isEmpty();

        motorsOff();
        assertThat(dog.received("motors off")).hasSize(1);
    }

    @Test
    void theMotorsOfADogWithUnknownPostureAreSwitchedOff() {
        dog.guessOnceDown = "unknown";

        motorsOff();

        assertThat(dog.received("motors off")).hasSize(1);
        assertThat(aibo.get("motors").isYes()).isFalse();
    }

    @Test
    void motorsStayOnWhenTheDogDidNotLieDown() {
        dog.staysUp = true;

        assertThatThrownBy(() -> motorsOff()).hasMessageContaining("in posture stand");
        assertThat(dog.received("motors off")).isEmpty();
    }

    @Test
    void motorsStayOnWhenLyingDownWasStopped() {
        dog.lastingMs = 3000;
        CompletableFuture<Void> off = driven.aside(() -> motorsOff());
        dog.awaitReceived("robot.lay");

        aibo.stop();

        assertThatThrownBy(() -> driven.join(off)).hasCauseInstanceOf(MotionStopped.class);
        assertThat(dog.received("motors off")).isEmpty();
    }

    @Test
    void aPostureIsTakenByAFunctionOfTheMemoryStick() {
        aibo.set("posture", "sit");

        assertThat(poses()).singleElement().asString().endsWith("+end: robot.sit()");
        assertThat(aibo.parameter("posture").moves()).isTrue();
    }

    @Test
    void aPostureThatTheMemoryStickLacksIsReported() {
        dog.knowsNo = "robot.beg";

        assertThatThrownBy(() -> aibo.set("posture", "beg")).hasMessageContaining("the dog refuses");
    }

    @Test
    void anErrorDuringGettingUpIsReported() {
        dog.set("robot.MyguessPosition()", "\"lay\"");
        dog.set("legLF1.load", "0.000000");
        driven.until(() -> !aibo.get("motors").isYes());

        aibo.move(5);

        assertThat(dog.received("motors on"))
                .singleElement()
                .asString()
                .matches("(\\w+)\\+end: \\{ motors on; wait\\(1000\\); \\1: robot.stand\\(\\) }");
    }

    private void motorsOff() {
        aibo.set("motors", List.of(Value.yesNo(false)));
    }

    private List<String> poses() {
        return dog.received("+end: ");
    }
}
