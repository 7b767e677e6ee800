package majic.hemisson.line;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** One question at a time, on a clock that the test moves. */
class ConversationTest {
    private static final Question CAMERA = Question.ask("R,C0,10,66", "r(,\\d{3}){102}", Question.msFor(409));
    private static final Question ULTRASONIC = Question.ask("R,E0,01,03", "r(,\\d{3}){3}", Question.msFor(13));
    private static final MotorValues AHEAD = new MotorValues(3, 3);

    private final ManualClock clock = new ManualClock();
    private final RecordingLink link = new RecordingLink();
    private final RecordedEvents told = new RecordedEvents();
    private Conversation conversation;

    @BeforeEach
    void begin() {
        conversation = new Conversation(link, clock, LineTimes.CABLE, told);
        conversation.mayBeDeafened(false);
    }

    @Test
    void theNextQuestionWaitsForTheAnswer() {
        conversation.ask(Question.PROXIMITY);
        conversation.ask(Question.SWITCHES);

        assertThat(link.commands()).containsExactly("N");
        hear("n,004,004,004,004,004,004,060,060");
        assertThat(link.commands()).containsExactly("N", "I");
    }

    @Test
    void aStopOvertakesQueuedQuestionsButNotTheAnswerUnderWay() {
        conversation.ask(Question.PROXIMITY);
        conversation.ask(Question.SWITCHES);
        conversation.stop();

        assertThat(link.commands()).containsExactly("N");
        hear("n,004,004,004,004,004,004,060,060");
        assertThat(link.commands()).containsExactly("N", "D,0,0");
    }

    @Test
    void aStopGoesBeforeTheRepetitionOfAMissedQuestion() {
        conversation.ask(Question.PROXIMITY);
        conversation.stop();
        pass(0.3);

        assertThat(link.commands()).containsExactly("N", "D,0,0");
    }

    @Test
    void aStopDiscardsQueuedMotions() {
        conversation.ask(Question.PROXIMITY);
        Exchange motion = conversation.ask(Question.wheels(AHEAD));
        conversation.stop();
        hear("n,004,004,004,004,004,004,060,060");
        hear("d");

        assertThat(motion.failure()).isEqualTo("stopped");
        assertThat(link.commands()).containsExactly("N", "D,0,0", "E");
    }

    @Test
    void aStopIsRepeatedUntilItIsAnsweredAndThenVerified() {
        conversation.stop();
        pass(0.3);
        pass(0.3);
        assertThat(link.commands()).containsExactly("D,0,0", "D,0,0", "D,0,0");

        hear("d");
        assertThat(conversation.isStopped()).isFalse();
        hear("e,00,00");
        assertThat(conversation.isStopped()).isTrue();
    }

    @Test
    void aRobotThatStillMovesAfterADoubtfulStopIsStoppedAgain() {
        conversation.stop();
        pass(0.3);
        hear("d");
        hear("e,03,03");

        assertThat(link.commands()).endsWith("E", "D,0,0");
    }

    @Test
    void aRobotThatMovedIsStoppedWhenItsSpeedsReadZero() {
        conversation.ask(Question.wheels(AHEAD));
        hear("d");
        assertThat(conversation.mayMove()).isTrue();

        conversation.stop();
        hear("d");
        assertThat(conversation.isStopped()).isFalse();
        hear("e,00,00");

        assertThat(conversation.isStopped()).isTrue();
    }

    @Test
    void aMissedAnswerWhileMovingStopsIt() {
        conversation.ask(Question.wheels(AHEAD));
        hear("d");
        conversation.ask(Question.PROXIMITY);
        conversation.ask(Question.wheels(AHEAD));
        pass(0.3);

        assertThat(link.commands()).containsExactly("D,3,3", "N", "D,0,0");
        assertThat(told.all()).contains("missed N in motion");
    }

    @Test
    void aMissedAnswerInMotionIsReportedAsSuchThoughTheRobotIsStoppedByThen() {
        conversation.ask(Question.wheels(AHEAD));
        hear("d");
        conversation.ask(Question.PROXIMITY);
        link.answeredBy(command -> hear(command.equals("E") ? "e,00,00" : "d"));
        pass(0.3);

        assertThat(conversation.isStopped()).isTrue();
        assertThat(told.all()).contains("missed N in motion");
    }

    @Test
    void aQuestionToAStationaryRobotIsRepeatedOnceIfItsAnswerIsMissed() {
        Exchange look = conversation.ask(Question.PROXIMITY);
        pass(0.3);
        assertThat(look.isDone()).isFalse();
        pass(0.3);

        assertThat(link.commands()).containsExactly("N", "N");
        assertThat(look.failure()).isEqualTo("no answer within 300 ms");
    }

    @Test
    void afterAMissedAnswerTheLineMustBeQuietBeforeItIsUsed() {
        conversation.ask(Question.PROXIMITY);
        clock.pass(0.29);
        conversation.bytesReceived();
        pass(0.02);
        assertThat(link.commands()).containsExactly("N");

        pass(0.08);
        assertThat(link.commands()).containsExactly("N", "N");
    }

    @Test
    void aLineThatAnswersNoQuestionIsDropped() {
        Exchange look = conversation.ask(Question.PROXIMITY);
        hear("d");
        hear("n,004,garbage");

        assertThat(look.isDone()).isFalse();
    }

    @Test
    void aMotionIsRefusedWhileADoubtfulStopIsNotConfirmed() {
        conversation.stop();
        pass(0.3);

        assertThat(conversation.ask(Question.wheels(AHEAD)).failure()).contains("not yet confirmed");
    }

    @Test
    void noMotionSurvivesAMissedAnswer() {
        conversation.stop();
        Exchange motion = conversation.ask(Question.wheels(AHEAD));
        pass(0.3);

        assertThat(motion.failure()).isNotNull();
    }

    @Test
    void aGreetingDiscardsTheQuestionsAndSendsAStop() {
        Exchange look = conversation.ask(Question.PROXIMITY);
        hear("HemiOS V1.50 , K-Team");
        pass(0.1);

        assertThat(look.failure()).isEqualTo("the robot was reset");
        assertThat(told.all()).contains("reset");
    }

    @Test
    void aRobotThatWasResetIsAskedForItsSpeedsBeforeItIsSentAnythingLong() {
        hear("HemiOS V1.50 , K-Team");
        Exchange motion = conversation.ask(Question.wheels(AHEAD));
        pass(0.1);
        assertThat(link.commands()).containsExactly("E");
        assertThat(motion.failure()).isNotNull();

        hear("e,03,03");
        assertThat(link.commands()).containsExactly("E", "D,0,0");
    }

    @Test
    void aRobotThatSetsItsOwnSpeedsIsStoppedAgainAfterAPause() {
        conversation.stop();
        hear("d");
        hear("e,10,05");
        hear("d");
        hear("e,-5,-10");
        assertThat(link.commands()).containsExactly("D,0,0", "E", "D,0,0", "E");

        pass(0.1);
        assertThat(link.commands()).endsWith("E", "D,0,0");
    }

    @Test
    void continuousNoiseDoesNotPreventAStop() {
        conversation.ask(Question.wheels(AHEAD));
        hear("d");
        conversation.ask(Question.PROXIMITY);
        pass(0.3);
        for (int noise = 0; noise < 30; noise++) {
            hear("x");
            pass(0.05);
        }

        assertThat(link.commands()).contains("D,0,0");
    }

    @Test
    void aLongQuestionIsRefusedWhileItMoves() {
        conversation.ask(Question.wheels(AHEAD));
        hear("d");

        assertThat(conversation.ask(Question.MODULES).failure()).contains("while the robot moves");
        assertThat(conversation.ask(CAMERA).failure()).contains("while the robot moves");
        assertThat(conversation.ask(ULTRASONIC).failure()).isNull();
        assertThat(link.commands()).containsExactly("D,3,3", "R,E0,01,03");
    }

    @Test
    void aQueuedLongQuestionFailsWhenAMotionIsSentBeforeIt() {
        conversation.ask(Question.PROXIMITY);
        conversation.ask(Question.wheels(AHEAD));
        Exchange camera = conversation.ask(CAMERA);
        hear("n,004,004,004,004,004,004,060,060");
        hear("d");

        assertThat(camera.failure()).contains("while the robot moves");
        assertThat(link.commands()).containsExactly("N", "D,3,3");
    }

    @Test
    void anUnansweredVerificationRepeatsTheStop() {
        conversation.stop();
        hear("d");
        pass(0.3);

        assertThat(conversation.isStopped()).isFalse();
        assertThat(link.commands()).containsExactly("D,0,0", "E", "D,0,0");
    }

    @Test
    void aStopDuringTheVerificationOfAnotherDiscardsMotionsAndSendsNothing() {
        conversation.ask(Question.wheels(AHEAD));
        hear("d");
        conversation.stop();
        hear("d");
        Exchange motion = conversation.ask(Question.wheels(AHEAD));
        conversation.stop();
        hear("e,00,00");

        assertThat(conversation.isStopped()).isTrue();
        assertThat(motion.failure()).isNotNull();
        assertThat(link.commands()).containsExactly("D,3,3", "D,0,0", "E");
    }

    @Test
    void aStopDuringAVerificationThatFindsTheRobotMovingIsSent() {
        conversation.ask(Question.wheels(AHEAD));
        hear("d");
        conversation.stop();
        hear("d");
        conversation.stop();
        hear("e,03,03");

        assertThat(link.commands()).containsExactly("D,3,3", "D,0,0", "E", "D,0,0");
    }

    @Test
    void aStopIsCertainUntilTheRobotIsMovedOrMissesAnAnswer() {
        assertThat(conversation.isCertainlyStopped()).isFalse();
        conversation.stop();
        hear("d");
        hear("e,00,00");
        assertThat(conversation.isCertainlyStopped()).isTrue();

        conversation.ask(Question.PROXIMITY);
        pass(1);
        assertThat(conversation.isCertainlyStopped()).isFalse();
    }

    @Test
    void aNewerMotionReplacesOneThatWaits() {
        conversation.ask(Question.PROXIMITY);
        conversation.ask(Question.wheels(AHEAD));
        conversation.ask(Question.wheels(new MotorValues(4, 4)));
        hear("n,004,004,004,004,004,004,060,060");
        hear("d");

        assertThat(link.commands()).containsExactly("N", "D,4,4");
    }

    @Test
    void theStopOfAFirmwareThatCannotReportSpeedsCountsWithoutVerification() {
        conversation.ask(Question.wheels(AHEAD));
        hear("d");
        conversation.stop();
        hear("d");
        hear("Unknown Command ?!");

        assertThat(conversation.isStopped()).isTrue();
    }

    @Test
    void aStopAfterTheEndOfTheConnectionDoesNotUndoAConfirmation() {
        conversation.ask(Question.wheels(AHEAD));
        hear("d");
        conversation.stop();
        hear("d");
        hear("e,00,00");
        conversation.end("closed");

        conversation.stop();

        assertThat(conversation.isStopped()).isTrue();
    }

    @Test
    void aRobotThatSetsItsOwnSpeedsCountsAsStoppedAfterASecondOfZeros() {
        conversation.setsItsOwnSpeeds(true);
        conversation.stop();
        hear("d");
        pass(0.1);
        hear("e,00,00");
        assertThat(conversation.isStopped()).isFalse();

        for (int look = 0; look < 8; look++) {
            pass(0.1);
            hear("e,00,00");
        }
        assertThat(conversation.isStopped()).isFalse();
        pass(0.1);
        hear("e,00,00");
        assertThat(conversation.isStopped()).isTrue();
    }

    @Test
    void aQuestionInMotionCarriesTheArgumentsOfAStop() {
        moveOnABufferedLine();
        conversation.ask(Question.PROXIMITY);
        conversation.stop();
        assertThat(link.commands()).containsExactly("D,3,3", "N,0,0");

        pass(0.1);
        assertThat(link.commands()).containsExactly("D,3,3", "N,0,0", "D");
    }

    @Test
    void nothingIsSentAfterAStopBehindAQuestionUntilTheLineCountsAsEmpty() {
        moveOnABufferedLine();
        conversation.ask(Question.PROXIMITY);
        pass(1);
        assertThat(link.commands()).containsExactly("D,3,3", "N,0,0", "D");
        assertThat(told.all()).contains("missed N in motion");

        for (int tick = 0; tick < 39; tick++) {
            pass(0.05);
        }
        assertThat(link.commands()).hasSize(3);
        pass(0.05);
        pass(0.3);
        assertThat(link.commands()).containsExactly("D,3,3", "N,0,0", "D", "D,0,0", "D,0,0");
    }

    @Test
    void theAnswersToAQuestionAndToTheStopBehindItAreReported() {
        moveOnABufferedLine();
        Exchange look = conversation.ask(Question.PROXIMITY);
        conversation.stop();
        pass(0.1);

        hear("n,004,004,004,004,004,004,060,060");
        assertThat(look.reply()).isNotNull();
        assertThat(link.commands()).hasSize(3);
        hear("d");
        hear("e,00,00");
        assertThat(conversation.isStopped()).isTrue();
    }

    @Test
    void aStopIsSentAtOnceBehindAQuestionWithABriefAnswer() {
        conversation = new Conversation(link, clock, LineTimes.BUFFERED, told);
        conversation.mayBeDeafened(false);
        conversation.receiver(ReceiverLimits.K_TEAM);
        conversation.ask(Question.wheels(AHEAD));
        conversation.stop();

        assertThat(link.commands()).containsExactly("D,3,3", "D,0,0");
    }

    @Test
    void aStopWaitsBehindAQuestionWithoutItsArgumentsUntilTheLineCountsAsEmpty() {
        moveOnABufferedLine();
        conversation.ask(ULTRASONIC);
        conversation.stop();
        pass(1.9);
        assertThat(link.commands()).containsExactly("D,3,3", "R,E0,01,03");

        pass(0.1);
        assertThat(link.commands()).containsExactly("D,3,3", "R,E0,01,03", "D,0,0");
    }

    @Test
    void aLateAnswerFreesTheLine() {
        moveOnABufferedLine();
        conversation.ask(ULTRASONIC);
        pass(1);
        assertThat(link.commands()).containsExactly("D,3,3", "R,E0,01,03");

        hear("r,001,002,003");
        pass(0.1);
        assertThat(link.commands()).containsExactly("D,3,3", "R,E0,01,03", "D,0,0");
    }

    @Test
    void anUnknownReceiverGetsOneCommandAtATime() {
        conversation = new Conversation(link, clock, LineTimes.BUFFERED, told);
        conversation.mayBeDeafened(false);
        conversation.ask(Question.wheels(AHEAD));
        conversation.stop();
        pass(1.9);
        assertThat(link.commands()).containsExactly("D,3,3");

        pass(0.1);
        assertThat(link.commands()).containsExactly("D,3,3", "D,0,0");
    }

    private void moveOnABufferedLine() {
        conversation = new Conversation(link, clock, LineTimes.BUFFERED, told);
        conversation.mayBeDeafened(false);
        conversation.receiver(ReceiverLimits.K_TEAM);
        conversation.ask(Question.wheels(AHEAD));
        hear("d");
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
