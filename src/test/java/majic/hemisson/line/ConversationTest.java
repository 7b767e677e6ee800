package majic.hemisson.line;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** One question at a time, over a cable, on a clock that the test moves. */
class ConversationTest {
    private static final Question CAMERA = Question.ask("R,C0,10,66", "r(,\\d{3}){102}", Question.msFor(409));

    private final TestedConversation rig = TestedConversation.overCable();

    @Test
    void theNextQuestionWaitsForTheAnswer() {
        rig.conversation.ask(Question.PROXIMITY);
        rig.conversation.ask(Question.SWITCHES);

        assertThat(rig.link.commands()).containsExactly("N");
        rig.receive("n,004,004,004,004,004,004,060,060");
        assertThat(rig.link.commands()).containsExactly("N", "I");
    }

    @Test
    void aMissedAnswerWhileMovingStopsIt() {
        rig.conversation.ask(Question.wheels(TestedConversation.AHEAD));
        rig.receive("d");
        rig.conversation.ask(Question.PROXIMITY);
        rig.conversation.ask(Question.wheels(TestedConversation.AHEAD));
        rig.pass(0.3);

        assertThat(rig.link.commands()).containsExactly("D,3,3", "N", "D,0,0");
        assertThat(rig.events.all()).contains("missed N in motion");
    }

    @Test
    void aMissedAnswerInMotionIsReportedAsSuchThoughTheRobotIsStoppedByThen() {
        rig.conversation.ask(Question.wheels(TestedConversation.AHEAD));
        rig.receive("d");
        rig.conversation.ask(Question.PROXIMITY);
        rig.link.answeredBy(command -> rig.receive(command.equals("E") ? "e,00,00" : "d"));
        rig.pass(0.3);

        assertThat(rig.conversation.isStopped()).isTrue();
        assertThat(rig.events.all()).contains("missed N in motion");
    }

    @Test
    void aQuestionToAStationaryRobotIsRepeatedOnceIfItsAnswerIsMissed() {
        Exchange look = rig.conversation.ask(Question.PROXIMITY);
        rig.pass(0.3);
        assertThat(look.isDone()).isFalse();
        rig.pass(0.3);

        assertThat(rig.link.commands()).containsExactly("N", "N");
        assertThat(look.failure()).isEqualTo("no answer within 300 ms");
    }

    @Test
    void afterAMissedAnswerTheLineMustBeQuietBeforeItIsUsed() {
        rig.conversation.ask(Question.PROXIMITY);
        rig.clock.pass(0.29);
        rig.conversation.bytesReceived();
        rig.pass(0.02);
        assertThat(rig.link.commands()).containsExactly("N");

        rig.pass(0.08);
        assertThat(rig.link.commands()).containsExactly("N", "N");
    }

    @Test
    void aLineThatAnswersNoQuestionIsDropped() {
        Exchange look = rig.conversation.ask(Question.PROXIMITY);
        rig.receive("d");
        rig.receive("n,004,garbage");

        assertThat(look.isDone()).isFalse();
    }

    @Test
    void aGreetingDiscardsTheQuestionsAndSendsAStop() {
        Exchange look = rig.conversation.ask(Question.PROXIMITY);
        rig.receive("HemiOS V1.50 , K-Team");
        rig.pass(0.1);

        assertThat(look.failure()).isEqualTo("the robot was reset");
        assertThat(rig.events.all()).contains("reset");
    }

    @Test
    void aRobotThatWasResetIsAskedForItsSpeedsBeforeItIsSentAnythingLong() {
        rig.receive("HemiOS V1.50 , K-Team");
        Exchange motion = rig.conversation.ask(Question.wheels(TestedConversation.AHEAD));
        rig.pass(0.1);
        assertThat(rig.link.commands()).containsExactly("E");
        assertThat(motion.failure()).isNotNull();

        rig.receive("e,03,03");
        assertThat(rig.link.commands()).containsExactly("E", "D,0,0");
    }

    @Test
    void aLongQuestionIsRefusedWhileItMoves() {
        rig.conversation.ask(Question.wheels(TestedConversation.AHEAD));
        rig.receive("d");

        assertThat(rig.conversation.ask(Question.MODULES).failure()).contains("while the robot moves");
        assertThat(rig.conversation.ask(CAMERA).failure()).contains("while the robot moves");
        assertThat(rig.conversation.ask(TestedConversation.ULTRASONIC).failure())
                .isNull();
        assertThat(rig.link.commands()).containsExactly("D,3,3", "R,E0,01,03");
    }

    @Test
    void aQueuedLongQuestionFailsWhenAMotionIsSentBeforeIt() {
        rig.conversation.ask(Question.PROXIMITY);
        rig.conversation.ask(Question.wheels(TestedConversation.AHEAD));
        Exchange camera = rig.conversation.ask(CAMERA);
        rig.receive("n,004,004,004,004,004,004,060,060");
        rig.receive("d");

        assertThat(camera.failure()).contains("while the robot moves");
        assertThat(rig.link.commands()).containsExactly("N", "D,3,3");
    }

    @Test
    void aNewerMotionReplacesOneThatWaits() {
        rig.conversation.ask(Question.PROXIMITY);
        rig.conversation.ask(Question.wheels(TestedConversation.AHEAD));
        rig.conversation.ask(Question.wheels(new MotorValues(4, 4)));
        rig.receive("n,004,004,004,004,004,004,060,060");
        rig.receive("d");

        assertThat(rig.link.commands()).containsExactly("N", "D,4,4");
    }
}
