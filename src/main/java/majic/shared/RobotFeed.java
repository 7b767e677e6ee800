package majic.shared;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import majic.bot.BotException;
import majic.shared.broker.BrokerConnection;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.Quality;
import majic.shared.message.Description;
import majic.shared.message.Presence;
import majic.shared.message.RobotMessage;
import majic.shared.message.RobotState;
import majic.shared.message.ScanMessage;
import majic.shared.message.SiteTopics;
import majic.shared.message.SiteTopics.Part;
import majic.shared.message.StateChange;
import majic.shared.message.UnusableMessageException;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * What arrives from one shared robot and its desk, from one connection of the driver to the next. Thread-safe; calls
 * its listener on the thread of the broker's connection.
 */
final class RobotFeed {
    private static final Logger LOG = System.getLogger(RobotFeed.class.getName());

    private final PooledBroker broker;
    private final SharedAddress address;
    private final SiteTopics topics;
    private final TimeSource time;
    private final Listener listener;
    private final List<Runnable> subscribed = new ArrayList<>();
    private final TransitTimes transit = new TransitTimes();
    private volatile @Nullable Description description;
    private volatile @Nullable Received state;
    private volatile @Nullable Presence presence;
    private volatile @Nullable String end;

    /** Is called with what arrives, and must not wait. */
    interface Listener {
        /** The description was published, for the first time or again. */
        void described(Description description);

        /** The presence of the desk has arrived. */
        void presenceKnown();

        /** A state, or a change of it, arrived that was published after the subscription. */
        void reported(Received received);

        /**
         * A scan arrived.
         *
         * @param nanos when, on the clock of the driver
         * @param ageS how long before it was measured, but for the time that the fastest message is on its way
         */
        void scanned(ScanMessage scan, long nanos, double ageS);

        /** A message for users arrived. */
        void message(RobotMessage message);

        /** The robot cannot be used any more; nothing else follows. */
        void gone(String reason);
    }

    /**
     * A state with all changes since, and when the last of them arrived.
     *
     * @param state the state
     * @param nanos on the clock of the driver
     * @param lateNanos how much longer than the fastest message it was on its way
     */
    record Received(RobotState state, long nanos, long lateNanos) {
        /** Returns when the robot reported it, on the clock of the driver. */
        long reportedNanos() {
            return nanos
                    - lateNanos
                    - TimeUnit.MILLISECONDS.toNanos(Math.max(0, state.motion().ageMs()));
        }
    }

    RobotFeed(PooledBroker broker, SharedAddress address, TimeSource time, Listener listener) {
        this.broker = broker;
        this.address = address;
        this.topics = new SiteTopics(address.broker().site());
        this.time = time;
        this.listener = listener;
    }

    /**
     * Subscribes to everything of the robot.
     *
     * @throws BotException if the broker refuses
     */
    void open() {
        Consumer<String> whenLost = reason -> end("the connection to the broker was lost: " + reason);
        broker.addLossListener(whenLost);
        subscribed.add(() -> broker.removeLossListener(whenLost));
        broker.expectReplies(topics);
        subscribe(topics.presence(address.desk()), Quality.AT_LEAST_ONCE, this::receivePresence);
        subscribe(topic(Part.DESCRIPTION), Quality.AT_LEAST_ONCE, this::receiveDescription);
        subscribe(topic(Part.STATE), Quality.AT_MOST_ONCE, this::receiveState);
        subscribe(topic(Part.CHANGES), Quality.AT_MOST_ONCE, this::receiveChange);
        subscribe(topic(Part.MESSAGES), Quality.AT_LEAST_ONCE, this::receiveMessage);
        try {
            subscribe(topic(Part.SCANS), Quality.AT_MOST_ONCE, this::receiveScan);
        } catch (BotException e) {
            LOG.log(Level.WARNING, "there are no scans of " + address.title(), e);
        }
    }

    private void subscribe(String filter, Quality quality, Consumer<BrokerMessage> receive) {
        BrokerConnection.Handler handler = message -> {
            try {
                if (!isOver()) {
                    receive.accept(message);
                }
            } catch (UnusableMessageException e) {
                LOG.log(Level.DEBUG, "a message on " + message.topic() + " cannot be used", e);
            }
        };
        broker.subscribe(filter, quality, handler);
        subscribed.add(() -> broker.unsubscribe(filter, handler));
    }

    private String topic(Part part) {
        return topics.robot(address.desk(), address.robot(), part);
    }

    /** Ends all subscriptions. Nothing is passed on any more. */
    void close() {
        if (end == null) {
            end = address.title() + " is not used any more";
        }
        subscribed.forEach(Runnable::run);
        subscribed.clear();
    }

    private void receivePresence(BrokerMessage message) {
        if (message.payload().length == 0) {
            return;
        }
        Presence now = Presence.parse(message.payload());
        presence = now;
        listener.presenceKnown();
        Description known = description;
        if (known == null || state == null) {
            return;
        }
        switch (now.state()) {
            case BROKEN -> end(address.desk() + " has lost its connection to the broker");
            case OFFLINE -> end(address.desk() + " does not share its robots any more");
            case ONLINE -> {
                if (!now.sender().session().equals(known.session())) {
                    end(address.desk() + " was started again");
                }
            }
        }
    }

    private void receiveDescription(BrokerMessage message) {
        if (message.payload().length > 0) {
            Description now = Description.parse(message.payload());
            description = now;
            listener.described(now);
        } else if (description != null) {
            end(address.desk() + " has removed its robot " + address.robot());
        }
    }

    /** A state that the broker has kept is older than it looks, so the clock of the desk cannot be taken from it. */
    private void receiveState(BrokerMessage message) {
        if (message.payload().length > 0 && !message.retained()) {
            receive(RobotState.parse(message.payload()));
        }
    }

    /** Without the state that it changes, a change means nothing; one that is overtaken by a state is out of date. */
    private void receiveChange(BrokerMessage message) {
        Received last = state;
        StateChange change = StateChange.parse(message.payload());
        if (last != null
                && !message.retained()
                && change.clock() >= last.state().clock()) {
            receive(last.state().with(change));
        }
    }

    private void receive(RobotState newest) {
        long nanos = time.nanos();
        Received now = new Received(newest, nanos, transit.lateNanos(newest.clock(), nanos));
        state = now;
        listener.reported(now);
    }

    private void receiveScan(BrokerMessage message) {
        if (state != null && !message.retained()) {
            ScanMessage scan = ScanMessage.parse(message.payload());
            long nanos = time.nanos();
            double lateS = transit.lateNanos(scan.clock(), nanos) / 1e9;
            listener.scanned(scan, nanos, lateS + Math.max(0, scan.ageMs()) / 1e3);
        }
    }

    private void receiveMessage(BrokerMessage message) {
        listener.message(RobotMessage.parse(message.payload()));
    }

    private void end(String reason) {
        if (end == null) {
            end = reason;
            listener.gone(reason);
        }
    }

    /** Returns whether anything has arrived. */
    boolean hasBegun() {
        return isOver() || presence != null || description != null || state != null;
    }

    /** Returns whether everything has arrived that a connected robot has, or it is certain that it will not. */
    boolean isDecided() {
        Presence there = presence;
        boolean absent = there != null
                && (there.state() != Presence.State.ONLINE
                        || description == null && !there.robots().contains(address.robot()));
        return isOver() || absent || description != null && state != null;
    }

    /** Returns whether the robot cannot be used any more. */
    boolean isOver() {
        return end != null;
    }

    /** Returns why the robot cannot be used any more, as a sentence; null if it can. */
    @Nullable
    String end() {
        return end;
    }

    /** Returns whether one more line of the desk is shown; counts it if not. */
    boolean allowsLine() {
        return broker.lines(address).allows();
    }

    /** Returns how many lines of the desk were left out, if that is to be said now; otherwise 0. */
    long linesLeftOut() {
        return broker.lines(address).countToReport();
    }

    /** Returns the newest description; null before the first one. */
    @Nullable
    Description description() {
        return description;
    }

    /** Returns the newest state; null before the first one. */
    @Nullable
    Received state() {
        return state;
    }

    /** Returns the holder by the newest state; before the first one the robot counts as free. */
    RobotHolder holder() {
        Received last = state;
        RobotState.Holder holder = last == null ? null : last.state().holder();
        return new RobotHolder(holder, holder != null && holder.sessionHash().equals(broker.sessionHash()));
    }

    /** Returns the newest presence of the desk; null before the first one. */
    @Nullable
    Presence presence() {
        return presence;
    }

    /** Returns the time since the newest state arrived, s; infinite before the first one. */
    double silenceS() {
        Received last = state;
        return last == null ? Double.POSITIVE_INFINITY : time.secondsSince(last.nanos());
    }

    /**
     * Returns a moment on the clock of the desk, which is known from its newest state.
     *
     * @param ms how far from now
     * @throws BotException before the first state
     */
    long deskClockIn(long ms) {
        Received last = state;
        if (last == null) {
            throw new BotException(address.title() + " has not reported yet");
        }
        return last.state().clock() + Math.round(time.secondsSince(last.nanos()) * 1000) + ms;
    }
}
