package majic.shared.desk;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import java.util.function.ToLongFunction;
import majic.bot.FakeBot;
import majic.driver.BotDriver;
import majic.script.conditions.Selection;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.Quality;
import majic.shared.message.HoldMessage;
import majic.shared.message.RequestReply;
import majic.shared.message.RequestReply.Outcome;
import majic.shared.message.RequestedAction;
import majic.shared.message.RobotState;
import majic.shared.message.RobotState.Holder;
import majic.shared.message.SiteTopics.Part;
import majic.shared.message.StateChange;
import majic.team.Member;
import majic.team.Owner;
import majic.team.QueuedCommand;
import majic.team.TeamListener;
import majic.time.Signal;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/**
 * Tests the hold of a shared robot: what begins it, what is refused meanwhile, and each reason for which the desk ends
 * it.
 */
class HoldsTest {
    @AutoClose
    private final SharingRig rig = SharingRig.started();

    private final FakeBot bot = (FakeBot) BotDriver.of(rig.team.member(1).bot());
    private final Member member = rig.team.member(1);
    private final RemoteUser anna = rig.user("desk1", "Anna").beat();

    private long count(String sent) {
        return bot.sent().stream().filter(sent::equals).count();
    }

    private void moving() {
        anna.move(900);
        rig.clock.until(() -> bot.state().moving());
    }

    /** Waits until the robot is halted and free; returns how long that takes, seconds. */
    private double secondsUntilHalted() {
        long begin = rig.clock.time().nanos();
        rig.clock.until(() -> count("halt") > 0 && member.owner() == null);
        return rig.clock.time().secondsSince(begin);
    }

    @Test
    void aRobotWhoseHolderFallsSilentIsHaltedAfterOneSecond() {
        moving();
        anna.stopBeating();

        assertThat(secondsUntilHalted()).isBetween(0.7, 1.1);
        assertThat(anna.outcome(1).outcome()).isEqualTo(Outcome.STOPPED);
        rig.clock.until(() -> rig.isSaid("no sign of life of Anna at desk1 for 1 s; the robot is stopped"));
    }

    @Test
    void heartbeatsThatComeTooLateDoNotCount() {
        moving();
        anna.connection.holdBack();
        rig.sleep(0.9);
        anna.connection.deliver();

        assertThat(secondsUntilHalted()).isLessThan(0.3);
    }

    /** The robot reports nothing meanwhile, so only the desk's clock is new. */
    @Test
    void aHolderMayAnswerEachStateAndChangeByAHeartbeat() {
        moving();
        anna.stopBeating();
        answerBy(Part.STATE, payload -> RobotState.parse(payload).clock());
        answerBy(Part.CHANGES, payload -> StateChange.parse(payload).clock());
        rig.sleep(10);

        assertThat(anna.state().holder()).isNotNull();
        assertThat(count("halt")).isZero();
    }

    private void answerBy(Part part, ToLongFunction<byte[]> clock) {
        anna.connection.subscribe(anna.topic(1, part), Quality.AT_MOST_ONCE, message -> {
            long validUntil = clock.applyAsLong(message.payload()) + 700;
            anna.publish(Part.HOLD, new HoldMessage(anna.sender, validUntil).toJson(), Quality.AT_MOST_ONCE, "");
        });
    }

    /** The timer looks for missing heartbeats, so nothing may block it. */
    @Test
    void aListenerThatBlocksAtTheEndOfAnUnusedHoldDoesNotBlockTheTimerOfTheDesk() {
        Signal released = rig.clock.time().signal();
        AtomicBoolean isReleased = new AtomicBoolean();
        AtomicBoolean blocked = new AtomicBoolean();
        rig.team.addListener(new TeamListener() {
            @Override
            public void ownerChanged(Member robot) {
                if (robot.owner() == null) {
                    blocked.set(true);
                    await(released, isReleased::get);
                }
            }
        });
        anna.outcome(anna.ask(new RequestedAction.Move(100, "")));
        rig.clock.until(blocked::get);
        long clock = anna.state().clock();

        try {
            anna.until(state -> state.clock() >= clock + 3000);
        } finally {
            isReleased.set(true);
            released.raise();
        }
    }

    private static void await(Signal signal, BooleanSupplier condition) {
        try {
            signal.await(condition, Signal.FOR_EVER);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Test
    void heartbeatsOfAnotherSessionDoNotCount() {
        RemoteUser eve = rig.user("desk1", "Anna").beat();
        moving();
        anna.stopBeating();

        assertThat(secondsUntilHalted()).isBetween(0.7, 1.1);
        eve.stopBeating();
    }

    @Test
    void nothingResumesWhenTheHolderIsBack() {
        moving();
        anna.stopBeating();
        secondsUntilHalted();
        long sent = bot.sent().size();
        anna.beat();
        rig.sleep(5);

        assertThat(bot.sent()).hasSize((int) sent);
        assertThat(member.owner()).isNull();
    }

    @Test
    void aRobotIsHaltedWhenTheBrokerIsGone() {
        moving();
        rig.broker.stop();

        assertThat(secondsUntilHalted()).isLessThan(0.1);
        rig.clock.until(() -> rig.isSaid("the connection with the broker is lost"));
    }

    @Test
    void aRobotIsHaltedWhenTheCableOfItsDeskIsCut() {
        moving();
        rig.connection().cut();

        assertThat(secondsUntilHalted()).isLessThan(1.1);
    }

    @Test
    void localStopAndLocalCommandsWorkWithTheBrokerDead() {
        rig.broker.stop();
        rig.clock.until(() -> !rig.connection().isConnected());
        member.submit(
                new QueuedCommand(
                        "move 900", true, robot -> List.of(robot.move(900).toString())),
                null);
        rig.clock.until(() -> bot.state().moving());
        rig.team.stopAll();

        rig.clock.until(() -> count("halt") > 0);
        assertThat(rig.team.isLatched()).isTrue();
    }

    @Test
    void aRobotIsHaltedWhenThePresenceOfItsHolderBreaks() {
        moving();
        rig.broker.publish(presenceOfAnna("broken"));

        assertThat(secondsUntilHalted()).isLessThan(0.1);
        rig.clock.until(() -> rig.isSaid("desk1 has no connection any more; the robot is stopped"));
    }

    @Test
    void aRobotIsHaltedWhenTheDeskOfItsHolderEnds() {
        moving();
        rig.broker.publish(presenceOfAnna("offline"));

        assertThat(secondsUntilHalted()).isLessThan(0.1);
    }

    private BrokerMessage presenceOfAnna(String state) {
        return BrokerMessage.json(
                "lab/majic/1/desks/desk1/presence",
                "{\"state\":\"" + state + "\",\"session\":\"" + anna.sender.sessionHash() + "\",\"desk\":\"desk1\"}",
                Quality.AT_LEAST_ONCE);
    }

    @Test
    void onlyTheDeskOfTheRobotReceivesTheSessionOfTheHolder() {
        moving();
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
    void theLossOfTheRobotsOwnConnectionEndsTheHold() {
        moving();
        bot.cut();

        assertThat(anna.outcome(1).outcome()).isEqualTo(Outcome.LOST);
        rig.clock.until(() -> member.owner() == null);
        anna.until(state -> state.link().lostReason().contains("connection lost"));
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
    void aSessionThatLostItsHoldWaitsEvenIfAnotherOneLosesItToo() {
        RemoteUser carl = rig.user("desk3", "Carl").beat();
        moving();
        rig.team.stop(List.of(member), null);
        rig.clock.until(() -> member.isIdle() && member.owner() == null);
        carl.outcome(carl.ask(new RequestedAction.Hold()));
        rig.team.stop(List.of(member), null);
        rig.clock.until(() -> member.owner() == null);

        RequestReply reclaimed = anna.outcome(anna.ask(new RequestedAction.Move(100, "")));

        assertThat(reclaimed.message()).startsWith("the robot was stopped; it can be claimed again in");
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
        moving();
        anna.ask(new RequestedAction.Free());

        assertThat(anna.outcome(1).outcome()).isEqualTo(Outcome.STOPPED);
        rig.clock.until(() -> count("halt") > 0 && member.owner() == null);
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
    void aLocalStopEndsTheHold() {
        anna.outcome(anna.ask(new RequestedAction.Hold()));
        rig.team.stop(List.of(member), null);

        rig.clock.until(() -> member.owner() == null);
        anna.until(state -> state.holder() == null);
    }

    @Test
    void aStopByTheHolderEndsTheMotionAndKeepsAnExplicitHold() {
        anna.outcome(anna.ask(new RequestedAction.Hold()));
        moving();
        anna.stop();

        assertThat(anna.outcome(2).outcome()).isEqualTo(Outcome.STOPPED);
        assertThat(anna.outcome("stop").outcome()).isEqualTo(Outcome.DONE);
        assertThat(anna.state().holder()).hasToString("Anna at desk1");
        assertThat(anna.outcome(anna.ask(new RequestedAction.Move(100, ""))).outcome())
                .isEqualTo(Outcome.DONE);
    }

    @Test
    void aStopByTheHolderEndsAHoldThatBeganWithAMotion() {
        moving();
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
        moving();
        carl.stop();
        carl.outcome("stop");
        long late = anna.ask(new RequestedAction.Move(500, ""));

        assertThat(anna.outcome(late).message()).startsWith("the robot was stopped; it can be claimed again in");
        assertThat(count("move 500")).isZero();
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
        assertThat(count("drive 200 0")).isPositive();
        carl.stop();
        carl.outcome("stop");
        long driven = count("drive 200 0");
        for (int n = 0; n < 30; n++) {
            anna.drive(200);
            rig.sleep(0.1);
        }

        assertThat(count("drive 200 0")).isEqualTo(driven);
        assertThat(member.owner()).isNull();
        rig.sleep(1.1);
        anna.drive(200);
        rig.clock.until(() -> count("drive 200 0") > driven);
    }

    @Test
    void aDriveLapsesWhenItIsNotRenewed() {
        anna.drive(200);
        rig.clock.until(() -> count("drive 200 0") == 1);
        long begin = rig.clock.time().nanos();
        rig.clock.until(() -> count("halt") == 1);

        assertThat(rig.clock.time().secondsSince(begin)).isBetween(0.55, 0.65);
    }

    @Test
    void aMalformedHeartbeatIsReportedAndDoesNotCount() {
        moving();
        anna.stopBeating();
        anna.publish(Part.HOLD, "{\"session\":7}".getBytes(), Quality.AT_MOST_ONCE, "");
        anna.publish(Part.HOLD, new HoldMessage(anna.sender, 1L << 60).toJson(), Quality.AT_MOST_ONCE, "");

        assertThat(secondsUntilHalted()).isBetween(0.7, 1.1);
        rig.clock.until(() -> rig.isSaid("\"session\" is 7; it is a text"));
    }

    @Test
    void aConditionMayNameTheRobotsOfTheDesk() {
        assertThat(new Selection(rig.team).names()).isEmpty();
        bot.putObstacle(1000);
        anna.outcome(anna.ask(new RequestedAction.Move(900, "1 distanceFront < 800mm")));

        assertThat(anna.state().motion().pose().xMm()).isLessThan(300);
    }
}
