package majic.hemisson.line;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Stops over a cable: their order among the questions, their repetition and verification. */
class ConversationStopTest {
    private final TestedConversation rig = TestedConversation.overCable();

    @Test
    void aStopOvertakesQueuedQuestionsButNotTheAnswerUnderWay() {
        rig.conversation.ask(Question.PROXIMITY);
        rig.conversation.ask(Question.SWITCHES);
        rig.conversation.stop();

        assertThat(rig.link.commands()).containsExactly("N");
        rig.receive("n,004,004,004,004,004,004,060,060");
        assertThat(rig.link.commands()).containsExactly("N", "D,0,0");
    }

    @Test
    void aStopGoesBeforeTheRepetitionOfAMissedQuestion() {
        rig.conversation.ask(Question.PROXIMITY);
        rig.conversation.stop();
        rig.pass(0.3);

        assertThat(rig.link.commands()).containsExactly("N", "D,0,0");
    }

    @Test
    void aStopDiscardsQueuedMotions() {
        rig.conversation.ask(Question.PROXIMITY);
        Exchange motion = rig.conversation.ask(Question.wheels(TestedConversation.AHEAD));
        rig.conversation.stop();
        rig.receive("n,004,004,004,004,004,004,060,060");
        rig.receive("d");

        assertThat(motion.failure()).isEqualTo("stopped");
        assertThat(rig.link.commands()).containsExactly("N", "D,0,0", "E");
    }

    @Test
    void aStopIsRepeatedUntilItIsAnsweredAndThenVerified() {
        rig.conversation.stop();
        rig.pass(0.3);
        rig.pass(0.3);
        assertThat(rig.link.commands()).containsExactly("D,0,0", "D,0,0", "D,0,0");

        rig.receive("d");
        assertThat(rig.conversation.isStopped()).isFalse();
        rig.receive("e,00,00");
        assertThat(rig.conversation.isStopped()).isTrue();
    }

    @Test
    void aRobotThatStillMovesAfterADoubtfulStopIsStoppedAgain() {
        rig.conversation.stop();
        rig.pass(0.3);
        rig.receive("d");
        rig.receive("e,03,03");

        assertThat(rig.link.commands()).endsWith("E", "D,0,0");
    }

    @Test
    void aRobotThatMovedIsStoppedWhenItsSpeedsReadZero() {
        rig.conversation.ask(Question.wheels(TestedConversation.AHEAD));
        rig.receive("d");
        assertThat(rig.conversation.mayMove()).isTrue();

        rig.conversation.stop();
        rig.receive("d");
        assertThat(rig.conversation.isStopped()).isFalse();
        rig.receive("e,00,00");

        assertThat(rig.conversation.isStopped()).isTrue();
    }

    @Test
    void aMotionIsRefusedWhileADoubtfulStopIsNotConfirmed() {
        rig.conversation.stop();
        rig.pass(0.3);

        assertThat(rig.conversation
                        .ask(Question.wheels(TestedConversation.AHEAD))
                        .failure())
                .contains("not yet confirmed");
    }

    @Test
    void noMotionSurvivesAMissedAnswer() {
        rig.conversation.stop();
        Exchange motion = rig.conversation.ask(Question.wheels(TestedConversation.AHEAD));
        rig.pass(0.3);

        assertThat(motion.failure()).isNotNull();
    }

    @Test
    void aRobotThatSetsItsOwnSpeedsIsStoppedAgainAfterAPause() {
        rig.conversation.stop();
        rig.receive("d");
        rig.receive("e,10,05");
        rig.receive("d");
        rig.receive("e,-5,-10");
        assertThat(rig.link.commands()).containsExactly("D,0,0", "E", "D,0,0", "E");

        rig.pass(0.1);
        assertThat(rig.link.commands()).endsWith("E", "D,0,0");
    }

    @Test
    void continuousNoiseDoesNotPreventAStop() {
        rig.conversation.ask(Question.wheels(TestedConversation.AHEAD));
        rig.receive("d");
        rig.conversation.ask(Question.PROXIMITY);
        rig.pass(0.3);
        for (int noise = 0; noise < 30; noise++) {
            rig.receive("x");
            rig.pass(0.05);
        }

        assertThat(rig.link.commands()).contains("D,0,0");
    }

    @Test
    void anUnansweredVerificationRepeatsTheStop() {
        rig.conversation.stop();
        rig.receive("d");
        rig.pass(0.3);

        assertThat(rig.conversation.isStopped()).isFalse();
        assertThat(rig.link.commands()).containsExactly("D,0,0", "E", "D,0,0");
    }

    @Test
    void aStopDuringTheVerificationOfAnotherDiscardsMotionsAndSendsNothing() {
        rig.conversation.ask(Question.wheels(TestedConversation.AHEAD));
        rig.receive("d");
        rig.conversation.stop();
        rig.receive("d");
        Exchange motion = rig.conversation.ask(Question.wheels(TestedConversation.AHEAD));
        rig.conversation.stop();
        rig.receive("e,00,00");

        assertThat(rig.conversation.isStopped()).isTrue();
        assertThat(motion.failure()).isNotNull();
        assertThat(rig.link.commands()).containsExactly("D,3,3", "D,0,0", "E");
    }

    @Test
    void aStopDuringAVerificationThatFindsTheRobotMovingIsSent() {
        rig.conversation.ask(Question.wheels(TestedConversation.AHEAD));
        rig.receive("d");
        rig.conversation.stop();
        rig.receive("d");
        rig.conversation.stop();
        rig.receive("e,03,03");

        assertThat(rig.link.commands()).containsExactly("D,3,3", "D,0,0", "E", "D,0,0");
    }

    @Test
    void aStopIsCertainUntilTheRobotIsMovedOrMissesAnAnswer() {
        assertThat(rig.conversation.isCertainlyStopped()).isFalse();
        rig.conversation.stop();
        rig.receive("d");
        rig.receive("e,00,00");
        assertThat(rig.conversation.isCertainlyStopped()).isTrue();

        rig.conversation.ask(Question.PROXIMITY);
        rig.pass(1);
        assertThat(rig.conversation.isCertainlyStopped()).isFalse();
    }

    @Test
    void theStopOfAFirmwareThatCannotReportSpeedsCountsWithoutVerification() {
        rig.conversation.ask(Question.wheels(TestedConversation.AHEAD));
        rig.receive("d");
        rig.conversation.stop();
        rig.receive("d");
        rig.receive("Unknown Command ?!");

        assertThat(rig.conversation.isStopped()).isTrue();
    }

    @Test
    void aStopAfterTheEndOfTheConnectionDoesNotUndoAConfirmation() {
        rig.conversation.ask(Question.wheels(TestedConversation.AHEAD));
        rig.receive("d");
        rig.conversation.stop();
        rig.receive("d");
        rig.receive("e,00,00");
        rig.conversation.end("closed");

        rig.conversation.stop();

        assertThat(rig.conversation.isStopped()).isTrue();
    }

    @Test
    void aRobotThatSetsItsOwnSpeedsCountsAsStoppedAfterASecondOfZeros() {
        rig.conversation.setOwnSpeeds(true);
        rig.conversation.stop();
        rig.receive("d");
        rig.pass(0.1);
        rig.receive("e,00,00");
        assertThat(rig.conversation.isStopped()).isFalse();

        for (int look = 0; look < 8; look++) {
            rig.pass(0.1);
            rig.receive("e,00,00");
        }
        assertThat(rig.conversation.isStopped()).isFalse();
        rig.pass(0.1);
        rig.receive("e,00,00");
        assertThat(rig.conversation.isStopped()).isTrue();
    }
}
