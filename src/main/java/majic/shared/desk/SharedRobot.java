package majic.shared.desk;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.MessageLimit;
import majic.shared.broker.Quality;
import majic.shared.message.HoldMessage;
import majic.shared.message.RequestReply;
import majic.shared.message.RequestReply.Outcome;
import majic.shared.message.RobotMessage;
import majic.shared.message.Sender;
import majic.shared.message.SiteTopics.Part;
import majic.shared.message.SpeedMessage;
import majic.shared.message.StopMessage;
import majic.shared.message.UnusableMessageException;
import majic.shared.vda5050.StoppableRobot;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/** One robot that this desk shares: its hold, and the messages for it. Thread-safe. */
final class SharedRobot implements StoppableRobot {
    /** More of each kind in a second are a mistake or an attack. Stops are never left out. */
    private static final int REQUESTS_PER_S = 200;

    private static final int SPEEDS_PER_S = 100;
    private static final int HEARTBEATS_PER_S = 50;

    /** Reading a longer message takes too long for the thread of the connection. */
    private static final int LONGEST_AT_ONCE_BYTES = 1024;

    /** More lines than this cannot be read while they appear. */
    private static final int LINES_PER_S = 20;

    private final DeskContext desk;
    private final Member member;
    private final SeenRequests seen = new SeenRequests();
    private final AtomicReference<@Nullable RobotHold> hold = new AtomicReference<>();
    private final ReclaimPause pause;
    private final RobotPublisher publisher;
    private final RobotScans scans;
    private final StopRequests stops;
    private final RobotInbox inbox;
    private final RequestRunner requests;
    private final SpeedDriver speeds;
    private final MessageLimit requestLimit;
    private final MessageLimit speedLimit;
    private final MessageLimit heartbeatLimit;
    private final MessageLimit mistakeLimit;
    private final MessageLimit lineLimit;
    private final MessageLimit stopLineLimit;
    private volatile boolean removed;

    SharedRobot(DeskContext desk, Member member) {
        this.desk = desk;
        this.member = member;
        this.pause = new ReclaimPause(desk.connection().time());
        this.publisher = new RobotPublisher(desk, member, this::hold);
        this.scans = new RobotScans(desk, member);
        this.stops = new StopRequests(desk, member, publisher::publishState);
        this.inbox = new RobotInbox(desk.worker());
        this.requests = new RequestRunner(desk, this, seen);
        this.speeds = new SpeedDriver(desk, member.number());
        this.requestLimit = new MessageLimit(desk.connection().time(), REQUESTS_PER_S);
        this.speedLimit = new MessageLimit(desk.connection().time(), SPEEDS_PER_S);
        this.heartbeatLimit = new MessageLimit(desk.connection().time(), HEARTBEATS_PER_S);
        this.mistakeLimit = new MessageLimit(desk.connection().time(), 1);
        this.lineLimit = new MessageLimit(desk.connection().time(), LINES_PER_S);
        this.stopLineLimit = new MessageLimit(desk.connection().time(), LINES_PER_S);
    }

    @Override
    public Member member() {
        return member;
    }

    MajicBot bot() {
        return member.bot();
    }

    RobotPublisher publisher() {
        return publisher;
    }

    RobotScans scans() {
        return scans;
    }

    /** The hold of another desk; null without one. */
    @Nullable
    RobotHold hold() {
        RobotHold now = hold.get();
        return now == null || now.hasEnded() ? null : now;
    }

    /** Handles a message to one of its topics, on the thread of the connection. */
    void received(Part part, BrokerMessage message) {
        if (message.retained()) {
            noticeMistake("a retained message to the topic \"" + message.topic() + "\" is ignored: it may be old");
            return;
        }
        switch (part) {
            case STOP -> stop(message);
            case HOLD -> heartbeat(message);
            case REQUEST ->
                forward(
                        requestLimit,
                        message,
                        held -> requests.receivedFrom(held, message),
                        () -> requests.received(message));
            case SPEED -> forward(speedLimit, message, held -> speedFrom(held, message), () -> speed(message));
            case DESCRIPTION, STATE, CHANGES, SCANS, MESSAGES -> {}
        }
    }

    /**
     * Handles a message of the holder at once, if that is possible, and everything else on the worker of the desk:
     * claiming the robot calls the listeners of the team, which may block.
     *
     * @param atOnce handles it without blocking; returns false, having done nothing, if it is no motion of the holder
     * @param onWorker handles any message
     */
    private void forward(MessageLimit limit, BrokerMessage message, Predicate<RobotHold> atOnce, Runnable onWorker) {
        if (!limit.allows()) {
            reportFlood(limit, message.topic());
            return;
        }
        RobotHold now = message.payload().length > LONGEST_AT_ONCE_BYTES || !inbox.isEmpty() ? null : hold();
        if ((now == null || !atOnce.test(now)) && !inbox.add(onWorker)) {
            reportFlood(limit, message.topic());
        }
    }

    private void reportFlood(MessageLimit limit, String topic) {
        long count = limit.countToReport();
        if (count > 0) {
            notice(count + (count == 1 ? " message" : " messages") + " to the topic \"" + topic
                    + "\" left out: more arrive than can be used");
        }
    }

    /** Reports a message of another program that cannot be used; one a second is enough to find the program. */
    void noticeMistake(String words) {
        if (mistakeLimit.allows()) {
            long before = mistakeLimit.countToReport();
            notice(before == 0 ? words : words + " (and " + before + " more messages that cannot be used)");
        }
    }

    /** Listeners of the team may block, so they are called on the worker. */
    @Override
    public void notice(String words) {
        desk.worker().submit(() -> member.notice(words));
    }

    /** A stop that cannot be read is still a stop. */
    private void stop(BrokerMessage message) {
        StopMessage stop = readStop(message);
        seen.stopped(stop);
        RobotHold now = hold();
        RobotHold own = now != null && now.isOf(stop.sender()) ? now : null;
        stops.stop(stop, reply -> desk.reply(message, reply), own == null ? null : own.owner(), written -> {
            if (own != null) {
                stoppedByHolder(own);
            }
            reportStop(written.sender().toString());
        });
    }

    @Override
    public void stop(String by, Consumer<Optional<String>> result) {
        StopMessage stop = new StopMessage(new Sender(by, "", "-"), 0, "");
        stops.stop(
                stop,
                reply -> result.accept(
                        reply.outcome() == Outcome.DONE ? Optional.empty() : Optional.of(reply.message())),
                null,
                written -> reportStop(by));
    }

    /** Every stop is carried out, but more lines than can be read are not shown. */
    private void reportStop(String by) {
        if (stopLineLimit.allows()) {
            notice("stopped by " + by);
        }
    }

    /** Stops the robot because of a malformed message on its topic for stops. */
    void stopForMalformed() {
        stop("a malformed message", result -> {});
    }

    private static void stoppedByHolder(RobotHold own) {
        if (own.isKept()) {
            own.stopped();
        } else {
            own.end();
        }
    }

    private static StopMessage readStop(BrokerMessage message) {
        try {
            return StopMessage.parse(message.payload());
        } catch (UnusableMessageException e) {
            return new StopMessage(new Sender("a message that cannot be read", "", "-"), 0, "");
        }
    }

    private void heartbeat(BrokerMessage message) {
        if (!heartbeatLimit.allows()) {
            reportFlood(heartbeatLimit, message.topic());
            return;
        }
        RobotHold now = hold();
        try {
            HoldMessage beat = HoldMessage.parse(message.payload());
            if (now != null && now.isOf(beat.sender()) && desk.clock().isValid(beat.validUntil())) {
                now.beat();
            }
        } catch (UnusableMessageException e) {
            noticeMistake(String.valueOf(e.getMessage()));
        }
    }

    private void speed(BrokerMessage message) {
        try {
            SpeedMessage speed = SpeedMessage.parse(message.payload());
            drive(speed, message, () -> claimToDrive(speed.sender()));
        } catch (BotException e) {
            refuseSpeed(message, e);
        }
    }

    /**
     * Handles a speed of the holder without blocking; returns false, having done nothing, if it is not of the holder.
     */
    private boolean speedFrom(RobotHold held, BrokerMessage message) {
        try {
            SpeedMessage speed = SpeedMessage.parse(message.payload());
            boolean isOfHolder = held.isOf(speed.sender());
            if (isOfHolder) {
                drive(speed, message, () -> held);
            }
            return isOfHolder;
        } catch (BotException e) {
            refuseSpeed(message, e);
            return true;
        }
    }

    private void refuseSpeed(BrokerMessage message, BotException why) {
        desk.reply(message, RequestReply.of(Outcome.REFUSED, String.valueOf(why.getMessage())));
    }

    private void drive(SpeedMessage speed, BrokerMessage message, Supplier<RobotHold> hold) {
        desk.clock().check(speed.validUntil());
        if (seen.isVoid(speed.sender().session(), speed.number())) {
            return;
        }
        bot().checkDrive(speed.mmPerSec(), speed.degPerSec(), 1);
        RobotHold now = hold.get();
        now.beat();
        speeds.drive(now, speed, message, seen);
    }

    private RobotHold claimToDrive(Sender sender) {
        RobotHold before = hold();
        RobotHold now = claim(sender, true);
        if (now != before) {
            member.notice("driven by " + now.holder());
        }
        return now;
    }

    /**
     * Returns the hold of a sender, which begins now if the robot is free. Called on the worker only, so no two claims
     * run at a time.
     *
     * @param continuous whether it is for one of a sequence of speeds
     * @throws BotException if the robot is held by another sender, owned, busy, latched, or was just taken away
     */
    RobotHold claim(Sender sender, boolean continuous) {
        RobotHold now = hold();
        if (now != null && now.isOf(sender)) {
            return now;
        }
        if (now != null) {
            throw new BotException(member.number() + " is held by " + now.holder() + "; a stop of the robot ends that");
        }
        if (removed || !desk.connection().isConnected()) {
            throw new BotException("robot " + member.number() + " is not shared any more");
        }
        pause.check(sender.session(), continuous);
        RobotHold begun = new RobotHold(member, sender, desk.connection().time(), this::holdEnded);
        begun.begin();
        hold.set(begun);
        desk.wake().run();
        return begun;
    }

    private void holdEnded(RobotHold one, boolean isTaken) {
        if (isTaken) {
            pause.begin(one.holder().session());
        }
        publisher.changed();
    }

    /** Gives the robot back for its holder, or because the holder does not use it; halts it first if it is in use. */
    void free(RobotHold one) {
        if (member.isIdle() && !bot().state().moving()) {
            one.end();
        } else {
            halt(List.of(this), desk);
        }
    }

    /** Ends the hold without a stop, because the connection with the robot is lost and no stop can be sent. */
    void linkLost() {
        RobotHold now = hold();
        if (now != null) {
            now.taken();
        }
        publisher.changed();
    }

    boolean isRemoved() {
        return removed;
    }

    /** Accepts no claim from now on. */
    void remove() {
        removed = true;
        scans.end();
        RobotHold now = hold();
        if (now != null) {
            now.end();
        }
    }

    /** Does what is due. Called by the timer of the desk. */
    void tick() {
        requests.acceptQueued();
        freeUnused();
        publisher.tick();
        scans.tick();
        reportLeftOut();
    }

    private void reportLeftOut() {
        long stopLines = stopLineLimit.countToReport();
        if (stopLines > 0) {
            notice("stopped " + stopLines + " more times");
        }
        long lines = lineLimit.countToReport();
        if (lines > 0) {
            publish(RobotMessage.Kind.MESSAGE, lines + (lines == 1 ? " line" : " lines") + " left out");
        }
    }

    /**
     * Ends a hold that began with a motion and is not used, on another thread: listeners of the team are called at its
     * end.
     */
    private void freeUnused() {
        RobotHold now = hold();
        if (now != null && now.isUnused()) {
            desk.connection().time().runAsync("freeing an unused robot", () -> {
                if (now.isUnused()) {
                    now.end();
                }
            });
        }
    }

    /**
     * Halts held robots and ends their holds, because their holders are gone: revokes at once, then stops all robots on
     * another thread. Returns at once.
     */
    static void halt(List<SharedRobot> robots, DeskContext desk) {
        List<RobotHold> holds =
                robots.stream().map(SharedRobot::hold).filter(Objects::nonNull).toList();
        holds.forEach(RobotHold::revoke);
        if (holds.isEmpty()) {
            return;
        }
        desk.connection().time().runAsync("halting robots whose holders are gone", () -> {
            desk.team().stop(holds.stream().map(RobotHold::member).toList(), null);
            holds.forEach(RobotHold::taken);
        });
    }

    /** Reports that its holder was halted because of missing heartbeats. */
    void reportSilence() {
        RobotHold now = hold.get();
        if (now != null) {
            notice("no sign of life of " + now.holder() + " for 1 s; the robot is stopped");
        }
    }

    /** Publishes a line about the robot, unless there are too many. */
    void publishLine(RobotMessage.Kind kind, String text) {
        if (lineLimit.allows()) {
            publish(kind, text);
        }
    }

    private void publish(RobotMessage.Kind kind, String text) {
        String topic = desk.topics().robot(desk.self().desk(), member.number(), Part.MESSAGES);
        desk.publish(BrokerMessage.json(topic, new RobotMessage(kind, text).toJson(), Quality.AT_LEAST_ONCE));
    }
}
