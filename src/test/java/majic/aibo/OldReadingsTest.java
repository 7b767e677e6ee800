package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.util.concurrent.CompletableFuture;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.bot.MotionFailed;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Readings that arrive late or not at all, and what becomes of a motion then. */
class OldReadingsTest {
    private static final Pattern AFTER = Pattern.compile(".*(?:, after|it had come) about (-?\\d+) mm");

    @AutoClose
    private final DrivenAibo driven = DrivenAibo.standing().connected();

    private final ScriptedDog dog = driven.dog;
    private final MajicAibo aibo = driven.aibo;

    @Test
    void aReadingCountsFromWhenTheDogMeasuredIt() throws InterruptedException {
        dog.slownessMs = 900;
        driven.until(() -> age() > 850);

        for (int count = 0; count < 20; count++) {
            aibo.time().sleep(0.1);
            assertThat(age()).isBetween(850.0, 1300.0);
        }
    }

    @Test
    void aDogWhoseReadingsAreOldIsNotMoved() {
        delayGradually();

        assertThatThrownBy(() -> aibo.move(100))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("its newest reading is ")
                .hasMessageContaining("after about 0 mm");
        assertThat(dog.received("robot.walk(")).isEmpty();
    }

    @Test
    void aDogWhoseReadingsBecomeOldIsStopped() {
        CompletableFuture<Void> walk = walk();

        delayGradually();

        assertThatThrownBy(() -> driven.join(walk)).hasMessageContaining("its newest reading is ");
        assertThat(dog.received("stop walk")).isNotEmpty();
    }

    @Test
    void theFailureOfAFrozenDogSaysWhatThePoseSays() {
        CompletableFuture<Void> walk = walk();
        driven.until(() -> aibo.state().pose().xMm() > 60);

        dog.slownessMs = 600_000;

        assertSaysWhereItIs(walk);
    }

    @Test
    void theFailureOfALostDogSaysWhatThePoseSays() {
        CompletableFuture<Void> walk = walk();
        driven.until(() -> aibo.state().pose().xMm() > 60);

        dog.hangUp();

        assertSaysWhereItIs(walk);
    }

    @Test
    void theFailureOfAFallenDogSaysWhatThePoseSays() {
        CompletableFuture<Void> walk = walk();
        driven.until(() -> aibo.state().pose().xMm() > 60);

        dog.set("accelZ.val", "9.800000");

        assertSaysWhereItIs(walk);
    }

    @Test
    void aWalkThatWasStoppedInSilenceIsNotDoneThoughTheDogAnswersAgain() {
        CompletableFuture<Void> walk = walk();
        dog.answersPolls = false;
        dog.awaitReceived("stop walk");
        dog.answersPolls = true;

        assertThatThrownBy(() -> driven.join(walk)).hasCauseInstanceOf(MotionFailed.class);
    }

    @Test
    void aPostureThatWasStoppedInSilenceIsNotDone() {
        dog.lastingMs = 6000;
        CompletableFuture<Void> sitting = driven.aside(() -> aibo.set("posture", "sit"));
        dog.awaitReceived("robot.sit");

        dog.answersPolls = false;

        assertThatThrownBy(() -> driven.join(sitting))
                .hasCauseInstanceOf(MotionFailed.class)
                .hasMessageContaining("no new reading came from the dog");
    }

    @Test
    void aWalkWhoseBeginWasNotReportedIsNotDone() {
        dog.reportsBegin = false;

        assertThatThrownBy(() -> aibo.move(50))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("did not report the begin of its walk");
    }

    private void delayGradually() {
        for (long late = 1000; late <= 3000; late += 1000) {
            dog.slownessMs = late;
            long at = late;
            driven.until(() -> age() > at);
        }
    }

    private void assertSaysWhereItIs(CompletableFuture<Void> walk) {
        Throwable failure = catchThrowable(() -> driven.join(walk));
        Matcher after = AFTER.matcher(failure.getMessage());

        assertThat(after.matches()).as(failure.getMessage()).isTrue();
        assertThat(Double.parseDouble(after.group(1)))
                .isEqualTo(Math.rint(aibo.state().pose().xMm()));
    }

    private double age() {
        Value age = aibo.get("age");
        return age instanceof Value.Number ? age.number() : 0;
    }

    private CompletableFuture<Void> walk() {
        CompletableFuture<Void> walk = driven.aside(() -> aibo.move(2000));
        driven.until(dog::isWalking);
        return walk;
    }
}
