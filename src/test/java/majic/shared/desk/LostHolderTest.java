package majic.shared.desk;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import java.util.function.ToLongFunction;
import majic.bot.FakeBot;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.Quality;
import majic.shared.message.HoldMessage;
import majic.shared.message.RequestReply.Outcome;
import majic.shared.message.RequestedAction;
import majic.shared.message.RobotState;
import majic.shared.message.SiteTopics.Part;
import majic.shared.message.StateChange;
import majic.team.Member;
import majic.team.QueuedCommand;
import majic.team.TeamListener;
import majic.time.Signal;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Tests that a desk halts a robot whose holder, broker or connection is lost. */
class LostHolderTest {
    @AutoClose
    private final SharingRig rig = SharingRig.started();

    private final FakeBot bot = rig.bot();
    private final Member member = rig.team.member(1);
    private final RemoteUser anna = rig.user("desk1", "Anna").beat();

    /** Waits until the robot is halted and free; returns how long that takes, seconds. */
    private double secondsUntilHalted() {
        long begin = rig.clock.time().nanos();
        rig.clock.until(() -> bot.count("halt") > 0 && member.owner() == null);
        return rig.clock.time().secondsSince(begin);
    }

    @Test
    void aRobotWhoseHolderFallsSilentIsHaltedAfterOneSecond() {
        anna.moveOn();
        anna.stopBeating();

        assertThat(secondsUntilHalted()).isBetween(0.7, 1.1);
        assertThat(anna.outcome(1).outcome()).isEqualTo(Outcome.STOPPED);
        rig.clock.until(() -> rig.isSaid("no sign of life of Anna at desk1 for 1 s; the robot is stopped"));
    }

    @Test
    void heartbeatsThatComeTooLateDoNotCount() {
        anna.moveOn();
        anna.connection.holdBack();
        rig.sleep(0.9);
        anna.connection.deliver();

        assertThat(secondsUntilHalted()).isLessThan(0.3);
    }

    /** The robot reports nothing meanwhile, so only the desk's clock is new. */
    @Test
    void aHolderMayAnswerEachStateAndChangeByAHeartbeat() {
        anna.moveOn();
        anna.stopBeating();
        answerBy(Part.STATE, payload -> RobotState.parse(payload).clock());
        answerBy(Part.CHANGES, payload -> StateChange.parse(payload).clock());
        rig.sleep(10);

        assertThat(anna.state().holder()).isNotNull();
        assertThat(bot.count("halt")).isZero();
    }

    private void answerBy(Part part, ToLongFunction<byte[]> clock) {
        anna.connection.subscribe(anna.topic(1, part), Quality.AT_MOST_ONCE, message -> {
            long validUntil = clock.applyAsLong(message.payload()) + 700;
            anna.publish(Part.HOLD, new HoldMessage(anna.sender, validUntil).toJson(), Quality.AT_MOST_ONCE, "");
        });
    }

    @Test
    void heartbeatsOfAnotherSessionDoNotCount() {
        RemoteUser eve = rig.user("desk1", "Anna").beat();
        anna.moveOn();
        anna.stopBeating();

        assertThat(secondsUntilHalted()).isBetween(0.7, 1.1);
        eve.stopBeating();
    }

    @Test
    void aMalformedHeartbeatIsReportedAndDoesNotCount() {
        anna.moveOn();
        anna.stopBeating();
        anna.publish(Part.HOLD, "{\"session\":7}".getBytes(), Quality.AT_MOST_ONCE, "");
        anna.publish(Part.HOLD, new HoldMessage(anna.sender, 1L << 60).toJson(), Quality.AT_MOST_ONCE, "");

        assertThat(secondsUntilHalted()).isBetween(0.7, 1.1);
        rig.clock.until(() -> rig.isSaid("\"session\" is 7; it is a text"));
    }

    @Test
    void nothingResumesWhenTheHolderIsBack() {
        anna.moveOn();
        anna.stopBeating();
        secondsUntilHalted();
        long sent = bot.sent().size();
        anna.beat();
        rig.sleep(5);

        assertThat(bot.sent()).hasSize((int) sent);
        assertThat(member.owner()).isNull();
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
    void aRobotIsHaltedWhenTheBrokerIsGone() {
        anna.moveOn();
        rig.broker.stop();

        assertThat(secondsUntilHalted()).isLessThan(0.1);
        rig.clock.until(() -> rig.isSaid("the connection with the broker is lost"));
    }

    @Test
    void aRobotIsHaltedWhenTheCableOfItsDeskIsCut() {
        anna.moveOn();
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

        rig.clock.until(() -> bot.count("halt") > 0);
        assertThat(rig.team.isLatched()).isTrue();
    }

    @Test
    void aRobotIsHaltedWhenThePresenceOfItsHolderBreaks() {
        anna.moveOn();
        rig.broker.publish(presenceOfAnna("broken"));

        assertThat(secondsUntilHalted()).isLessThan(0.1);
        rig.clock.until(() -> rig.isSaid("desk1 has no connection any more; the robot is stopped"));
    }

    @Test
    void aRobotIsHaltedWhenTheDeskOfItsHolderEnds() {
        anna.moveOn();
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
    void theLossOfTheRobotsOwnConnectionEndsTheHold() {
        anna.moveOn();
        bot.cut();

        assertThat(anna.outcome(1).outcome()).isEqualTo(Outcome.LOST);
        rig.clock.until(() -> member.owner() == null);
        anna.until(state -> state.link().lostReason().contains("connection lost"));
    }
}
