package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mockito.Mockito.mock;

import majic.driver.RobotWait;
import majic.environment.BotEnvironment;
import majic.hemisson.line.Conversation;
import majic.hemisson.line.CurrentSession;
import majic.hemisson.line.Exchange;
import majic.hemisson.line.HemissonSession;
import majic.hemisson.line.MotorValues;
import majic.hemisson.line.Question;
import majic.hemisson.line.StopConfirmation;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The stop at the end of a session. */
class StopConfirmationTest {
    @AutoClose
    private final ScriptedHemisson robot = new ScriptedHemisson();

    private final BotEnvironment environment = robot.environment();
    private final CurrentSession sessions = new CurrentSession(robot.address(), environment.time());
    private final StopConfirmation stopConfirmation = new StopConfirmation(
            sessions, new RobotWait(environment.time(), environment.time().signal()), () -> false, () -> null);
    private Conversation conversation;

    @BeforeEach
    void stopOnce() {
        HemissonSession session = sessions.open(mock());
        session.start();
        conversation = session.conversation();
        conversation.setDeafenable(false);
        conversation.stop();
        robot.clock().until(conversation::isStopped);
    }

    @Test
    void aStopThatIsInEffectIsNotRepeatedAtTheEnd() {
        assertThat(stopConfirmation.end()).isNull();

        assertThat(robot.commands()).containsExactly("D,0,0", "E");
    }

    @Test
    void aRobotThatMovesIsStoppedAtTheEnd() {
        Exchange motion = conversation.ask(Question.wheels(new MotorValues(3, 3)));
        robot.clock().until(motion::isDone);

        assertThat(stopConfirmation.end()).isNull();

        assertThat(robot.commands()).containsExactly("D,0,0", "E", "D,3,3", "D,0,0", "E");
    }
}
