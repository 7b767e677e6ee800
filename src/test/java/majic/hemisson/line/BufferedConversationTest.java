package majic.hemisson.line;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Stops behind questions on a line that holds bytes back, such as a radio link. */
class BufferedConversationTest {
    private final TestedConversation rig = TestedConversation.overBufferedLine();

    @Test
    void aQuestionInMotionCarriesTheArgumentsOfAStop() {
        moveAhead();
        rig.conversation.ask(Question.PROXIMITY);
        rig.conversation.stop();
        assertThat(rig.link.commands()).containsExactly("D,3,3", "N,0,0");

        rig.pass(0.1);
        assertThat(rig.link.commands()).containsExactly("D,3,3", "N,0,0", "D");
    }

    @Test
    void nothingIsSentAfterAStopBehindAQuestionUntilTheLineCountsAsEmpty() {
        moveAhead();
        rig.conversation.ask(Question.PROXIMITY);
        rig.pass(1);
        assertThat(rig.link.commands()).containsExactly("D,3,3", "N,0,0", "D");
        assertThat(rig.events.all()).contains("missed N in motion");

        for (int tick = 0; tick < 39; tick++) {
            rig.pass(0.05);
        }
        assertThat(rig.link.commands()).hasSize(3);
        rig.pass(0.05);
        rig.pass(0.3);
        assertThat(rig.link.commands()).containsExactly("D,3,3", "N,0,0", "D", "D,0,0", "D,0,0");
    }

    @Test
    void theAnswersToAQuestionAndToTheStopBehindItAreReported() {
        moveAhead();
        Exchange look = rig.conversation.ask(Question.PROXIMITY);
        rig.conversation.stop();
        rig.pass(0.1);

        rig.receive("n,004,004,004,004,004,004,060,060");
        assertThat(look.reply()).isNotNull();
        assertThat(rig.link.commands()).hasSize(3);
        rig.receive("d");
        rig.receive("e,00,00");
        assertThat(rig.conversation.isStopped()).isTrue();
    }

    @Test
    void aStopIsSentAtOnceBehindAQuestionWithABriefAnswer() {
        rig.conversation.receiver(ReceiverLimits.K_TEAM);
        rig.conversation.ask(Question.wheels(TestedConversation.AHEAD));
        rig.conversation.stop();

        assertThat(rig.link.commands()).containsExactly("D,3,3", "D,0,0");
    }

    @Test
    void aStopWaitsBehindAQuestionWithoutItsArgumentsUntilTheLineCountsAsEmpty() {
        moveAhead();
        rig.conversation.ask(TestedConversation.ULTRASONIC);
        rig.conversation.stop();
        rig.pass(1.9);
        assertThat(rig.link.commands()).containsExactly("D,3,3", "R,E0,01,03");

        rig.pass(0.1);
        assertThat(rig.link.commands()).containsExactly("D,3,3", "R,E0,01,03", "D,0,0");
    }

    @Test
    void aLateAnswerFreesTheLine() {
        moveAhead();
        rig.conversation.ask(TestedConversation.ULTRASONIC);
        rig.pass(1);
        assertThat(rig.link.commands()).containsExactly("D,3,3", "R,E0,01,03");

        rig.receive("r,001,002,003");
        rig.pass(0.1);
        assertThat(rig.link.commands()).containsExactly("D,3,3", "R,E0,01,03", "D,0,0");
    }

    @Test
    void anUnknownReceiverGetsOneCommandAtATime() {
        rig.conversation.ask(Question.wheels(TestedConversation.AHEAD));
        rig.conversation.stop();
        rig.pass(1.9);
        assertThat(rig.link.commands()).containsExactly("D,3,3");

        rig.pass(0.1);
        assertThat(rig.link.commands()).containsExactly("D,3,3", "D,0,0");
    }

    /** Drives a robot whose receiver is known. */
    private void moveAhead() {
        rig.conversation.receiver(ReceiverLimits.K_TEAM);
        rig.conversation.ask(Question.wheels(TestedConversation.AHEAD));
        rig.receive("d");
    }
}
