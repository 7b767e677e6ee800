package majic.shared.desk;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import majic.bot.FakeBot;
import majic.shared.message.RequestReply;
import majic.shared.message.RequestReply.Outcome;
import majic.shared.message.RequestedAction;
import majic.team.Member;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Tests which holds of a shared robot a stop ends, and when the robot can be claimed again. */
class StoppedHoldTest {
    @AutoClose
    private final SharingRig rig = SharingRig.started();

    private final FakeBot bot = rig.bot();
    private final Member member = rig.team.member(1);
    private final RemoteUser anna = rig.user("desk1", "Anna").beat();

    @Test
    void aStopByTheHolderEndsTheMotionAndKeepsAnExplicitHold() {
        anna.outcome(anna.ask(new RequestedAction.Hold()));
        anna.moveOn();
        anna.stop();

        assertThat(anna.outcome(2).outcome()).isEqualTo(Outcome.STOPPED);
        assertThat(anna.outcome("stop").outcome()).isEqualTo(Outcome.DONE);
        assertThat(anna.state().holder()).hasToString("Anna at desk1");
        assertThat(anna.outcome(anna.ask(new RequestedAction.Move(100, ""))).outcome())
                .isEqualTo(Outcome.DONE);
    }

    @Test
    void aStopByTheHolderEndsAHoldThatBeganWithAMotion() {
        anna.moveOn();
        anna.stop();
        anna.outcome("stop");

        rig.clock.until(() -> member.owner() == null);
        assertThat(anna.outcome(anna.ask(new RequestedAction.Move(100, ""))).outcome())
                .isEqualTo(Outcome.DONE);
    }

    @Test
    void aStopBySomebodyElseEndsTheHoldAndWhatItsHolderWasSending() {
        RemoteUser carl = rig.user("desk3", "Carl");
        anna.outcome(anna.ask(new RequestedAction.Hold()));
        anna.moveOn();
        carl.stop();
        carl.outcome("stop");
        long late = anna.ask(new RequestedAction.Move(500, ""));

        assertThat(anna.outcome(late).message()).startsWith("the robot was stopped; it can be claimed again in");
        assertThat(bot.count("move 500")).isZero();
        rig.sleep(1);
        assertThat(anna.outcome(anna.ask(new RequestedAction.Move(100, ""))).outcome())
                .isEqualTo(Outcome.DONE);
    }

    @Test
    void speedsThatGoOnAfterAStopDoNotClaimTheRobotAgain() {
        RemoteUser carl = rig.user("desk3", "Carl");
        for (int n = 0; n < 5; n++) {
            anna.drive(200);
            rig.sleep(0.1);
        }
        assertThat(bot.count("drive 200 0")).isPositive();
        carl.stop();
        carl.outcome("stop");
        long driven = bot.count("drive 200 0");
        for (int n = 0; n < 30; n++) {
            anna.drive(200);
            rig.sleep(0.1);
        }

        assertThat(bot.count("drive 200 0")).isEqualTo(driven);
        assertThat(member.owner()).isNull();
        rig.sleep(1.1);
        anna.drive(200);
        rig.clock.until(() -> bot.count("drive 200 0") > driven);
    }

    @Test
    void aSessionThatLostItsHoldWaitsEvenIfAnotherOneLosesItToo() {
        RemoteUser carl = rig.user("desk3", "Carl").beat();
        anna.moveOn();
        rig.team.stop(List.of(member), null);
        rig.clock.until(() -> member.isIdle() && member.owner() == null);
        carl.outcome(carl.ask(new RequestedAction.Hold()));
        rig.team.stop(List.of(member), null);
        rig.clock.until(() -> member.owner() == null);

        RequestReply reclaimed = anna.outcome(anna.ask(new RequestedAction.Move(100, "")));

        assertThat(reclaimed.message()).startsWith("the robot was stopped; it can be claimed again in");
    }

    @Test
    void aLocalStopEndsTheHold() {
        anna.outcome(anna.ask(new RequestedAction.Hold()));
        rig.team.stop(List.of(member), null);

        rig.clock.until(() -> member.owner() == null);
        anna.until(state -> state.holder() == null);
    }
}
