package majic.shared.desk;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import majic.bot.FakeBot;
import majic.script.conditions.Selection;
import majic.shared.broker.BrokerMessage;
import majic.shared.message.RequestReply;
import majic.shared.message.RequestReply.Outcome;
import majic.shared.message.RequestedAction;
import majic.shared.message.RobotState.Holder;
import majic.team.Member;
import majic.team.Owner;
import majic.team.QueuedCommand;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Tests the hold of a shared robot: what begins it, what is refused meanwhile, and what ends it without a stop. */
class HoldsTest {
    @AutoClose
    private final SharingRig rig = SharingRig.started();

    private final FakeBot bot = rig.bot();
    private final Member member = rig.team.member(1);
    private final RemoteUser anna = rig.user("desk1", "Anna").beat();

    @Test
    void onlyTheDeskOfTheRobotReceivesTheSessionOfTheHolder() {
        anna.moveOn();
        anna.until(state -> state.holder() != null);

        assertThat(anna.state().holder())
                .extracting(Holder::sessionHash)
                .isEqualTo(anna.sender.sessionHash())
                .isNotEqualTo(anna.sender.session());
        assertThat(rig.broker.published("#"))
                .filteredOn(message -> (message.topic() + message.text()).contains(anna.sender.session()))
                .extracting(BrokerMessage::topic)
                .isNotEmpty()
                .allMatch(topic -> topic.matches("lab/majic/1/desks/desk2/robots/1/(request|hold)"));
    }

    @Test
    void twoDesksThatClaimOneRobotGetItOneAtATime() {
        RemoteUser carl = rig.user("desk3", "Carl").beat();
        anna.outcome(anna.ask(new RequestedAction.Hold()));

        RequestReply second = carl.outcome(carl.ask(new RequestedAction.Hold()));
        RequestReply motion = carl.outcome(carl.ask(new RequestedAction.Move(100, "")));
        RequestReply giving = carl.outcome(carl.ask(new RequestedAction.Free()));
        anna.outcome(anna.ask(new RequestedAction.Free()));
        RequestReply third = carl.outcome(carl.ask(new RequestedAction.Hold()));

        assertThat(second.message()).isEqualTo("1 is held by Anna at desk1; a stop of the robot ends that");
        assertThat(motion.outcome()).isEqualTo(Outcome.REFUSED);
        assertThat(giving.message()).isEqualTo("the robot is held by Anna at desk1");
        assertThat(third.outcome()).isEqualTo(Outcome.DONE);
        assertThat(anna.state().holder()).extracting(Holder::desk).isEqualTo("desk3");
    }

    @Test
    void aLocalMotionIsRefusedWithTheHolder() {
        anna.outcome(anna.ask(new RequestedAction.Hold()));

        assertThatThrownBy(() -> member.check(true, null)).hasMessage("1 is held by Anna at desk1; \"1 stop\" ends it");
    }

    @Test
    void aRobotThatRunsAnActIsRefusedWithTheAct() {
        Owner act = new Owner(Owner.Kind.ACT, "WanderDog", () -> {});
        member.claim(act);

        RequestReply reply = anna.outcome(anna.ask(new RequestedAction.Move(100, "")));

        assertThat(reply.message()).isEqualTo("1 is running WanderDog; \"1 stop\" ends it");
        anna.until(state -> state.holder() != null);
        assertThat(anna.state().holder().work()).isEqualTo("running WanderDog");
        member.free(act);
    }

    @Test
    void aRobotThatIsGivenBackInMotionIsHalted() {
        anna.moveOn();
        anna.ask(new RequestedAction.Free());

        assertThat(anna.outcome(1).outcome()).isEqualTo(Outcome.STOPPED);
        rig.clock.until(() -> bot.count("halt") > 0 && member.owner() == null);
    }

    @Test
    void aRobotThatCarriesOutCommandsOfItsOwnDeskCannotBeClaimed() {
        member.submit(new QueuedCommand("move 900", true, robot -> List.of("" + robot.move(900))), null);
        rig.clock.until(() -> bot.state().moving());

        RequestReply reply = anna.outcome(anna.ask(new RequestedAction.Move(100, "")));

        assertThat(reply.message()).isEqualTo("1 is busy with commands of its own desk");
        rig.clock.until(() -> member.isIdle());
        assertThat(bot.state().pose().xMm()).isEqualTo(900);
    }

    @Test
    void aLatchedStopRefusesClaims() {
        rig.team.stopAll();

        RequestReply reply = anna.outcome(anna.ask(new RequestedAction.Hold()));

        assertThat(reply.message()).startsWith("STOP is latched");
    }

    @Test
    void aDriveLapsesWhenItIsNotRenewed() {
        anna.drive(200);
        rig.clock.until(() -> bot.count("drive 200 0") == 1);
        long begin = rig.clock.time().nanos();
        rig.clock.until(() -> bot.count("halt") == 1);

        assertThat(rig.clock.time().secondsSince(begin)).isBetween(0.55, 0.65);
    }

    @Test
    void aConditionMayNameTheRobotsOfTheDesk() {
        assertThat(new Selection(rig.team).names()).isEmpty();
        bot.putObstacle(1000);
        anna.outcome(anna.ask(new RequestedAction.Move(900, "1 distanceFront < 800mm")));

        assertThat(anna.state().motion().pose().xMm()).isLessThan(300);
    }
}
