package majic.hemisson.line;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** When a robot counts as out of control: while it may move and has missed an answer, and at no other time. */
class OutOfControlTest {
    private static final String SEEN = "n,004,004,004,004,004,004,060,060";

    private final ManualClock clock = new ManualClock();
    private final Conversation conversation =
            new Conversation(new RecordingLink(), clock, LineTimes.CABLE, new RecordedEvents());

    @BeforeEach
    void beginInRemoteControl() {
        conversation.setDeafenable(false);
    }

    @Test
    void anAnswerMissedBeforeTheMotionDoesNotCount() {
        conversation.ask(Question.PROXIMITY);
        pass(0.3);
        hear(SEEN);
        conversation.ask(Question.wheels(new MotorValues(3, 3)));
        hear("d");

        assertThat(conversation.mayMove()).isTrue();
        assertThat(conversation.isUnreached()).isFalse();
    }

    @Test
    void aRobotIsOutOfControlFromTheFirstMissedAnswerInMotionUntilAConfirmedStop() {
        conversation.ask(Question.wheels(new MotorValues(3, 3)));
        pass(0.3);
        assertThat(conversation.isUnreached()).isTrue();

        hear("d");
        assertThat(conversation.isUnreached()).isTrue();

        hear("e,00,00");
        assertThat(conversation.isUnreached()).isFalse();
    }

    @Test
    void aRobotThatWasSwitchedOnAgainIsStationary() {
        conversation.ask(Question.wheels(new MotorValues(3, 3)));
        pass(0.3);

        hear("HemiOS V1.50 , K-Team S.A.");

        assertThat(conversation.isUnreached()).isFalse();
    }

    private void hear(String line) {
        conversation.bytesReceived();
        conversation.received(Reply.of(line));
    }

    private void pass(double seconds) {
        clock.pass(seconds);
        conversation.tick();
    }
}
