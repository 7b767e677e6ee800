package majic.shared.desk;

import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.PublicationRefused;
import majic.shared.broker.Quality;
import majic.shared.message.Presence;
import majic.shared.message.Presence.State;
import majic.shared.message.SiteTopics;
import majic.time.Signal;
import org.jspecify.annotations.Nullable;

/**
 * Publishes that this desk is there, and keeps its name: refuses to begin while another desk has the name, and lets one
 * of two desks that took it at the same time withdraw. Thread-safe.
 */
final class DeskPresence {
    /** The will of a desk that has crashed arrives within this time, seconds. */
    private static final double WILL_S = 3;

    /**
     * How long the echo of an own message may take, behind which everything kept by the broker has arrived, seconds.
     */
    private static final double ECHO_S = 2;

    /** The broker forgets a desk of which nothing was published for so long, seconds. */
    static final int EXPIRY_S = 3600;

    /** How often something is published that expires so, seconds. */
    static final double RENEWAL_S = EXPIRY_S / 3.0;

    private final DeskContext desk;
    private final String program;
    private final Supplier<List<Integer>> robots;
    private final Consumer<String> withdraw;
    private final Signal changed;
    private volatile @Nullable Presence other;
    private volatile boolean echoed;
    private volatile @Nullable PublicationRefused refused;
    private volatile long publishedNanos;
    private volatile boolean active;
    private volatile List<Integer> published = List.of();

    /**
     * @param robots the numbers of the shared robots
     * @param withdraw called with the reason when this desk has to give up its name; on the thread of the connection
     */
    DeskPresence(DeskContext desk, String program, Supplier<List<Integer>> robots, Consumer<String> withdraw) {
        this.desk = desk;
        this.program = program;
        this.robots = robots;
        this.withdraw = withdraw;
        this.changed = desk.connection().time().signal();
    }

    /** The message that the broker publishes when this desk is gone. */
    static BrokerMessage will(SiteTopics topics, Presence self) {
        return BrokerMessage.json(
                        topics.presence(self.sender().desk()),
                        self.ended(State.BROKEN).toJson(),
                        Quality.AT_LEAST_ONCE)
                .retain()
                .expiringAfter(EXPIRY_S);
    }

    /**
     * Takes the name. Blocks until the broker has delivered what it keeps, and for 3 s more if another desk seems to be
     * there.
     *
     * @throws BotException if another desk has the name, or the broker refuses what a sharing desk has to publish
     */
    void takeName() {
        String topic = desk.topics().replies(desk.self().session());
        desk.connection().subscribe(topic, Quality.AT_LEAST_ONCE, message -> {
            echoed = true;
            changed.raise();
        });
        desk.publish(BrokerMessage.json(topic, "{}", Quality.AT_LEAST_ONCE), this::refused);
        try {
            changed.await(() -> echoed || refused != null, ECHO_S);
            requireNotRefused();
            if (!changed.await(() -> !isTaken(), WILL_S)) {
                throw new BotException(taken());
            }
            publishFirst();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new BotException("interrupted");
        } finally {
            desk.connection().unsubscribe(topic);
        }
    }

    /** Publishes the presence, and waits for the answer of the broker. */
    private void publishFirst() throws InterruptedException {
        active = true;
        AtomicBoolean answered = new AtomicBoolean();
        desk.connection().publish(message(State.ONLINE, robots.get()), problem -> {
            refused = problem instanceof PublicationRefused refusal ? refusal : null;
            answered.set(true);
            changed.raise();
        });
        changed.await(answered::get, ECHO_S);
        active = refused == null;
        requireNotRefused();
    }

    private void refused(PublicationRefused refusal) {
        refused = refusal;
        changed.raise();
    }

    private void requireNotRefused() {
        PublicationRefused refusal = refused;
        if (refusal != null) {
            throw new BotException(
                    "no robot is shared: " + refusal.getMessage() + "; a desk that shares robots needs a user who may"
                            + " write " + desk.topics().desk(desk.self().desk()) + " and "
                            + desk.topics().replies("#"),
                    refusal);
        }
    }

    private boolean isTaken() {
        Presence there = other;
        return there != null && there.state() == State.ONLINE;
    }

    private String taken() {
        Presence there = other;
        return desk.self().desk() + ": another program shares robots under this name"
                + (there == null || there.sender().person().isEmpty() ? "" : " (" + there.sender() + ")")
                + "; choose another one with --desk";
    }

    /** Handles the presence of a desk of the same name, on the thread of the connection. */
    void received(Presence presence) {
        if (presence.sender().session().equals(desk.self().session())) {
            return;
        }
        other = presence;
        changed.raise();
        if (!active) {
            return;
        }
        if (presence.state() == State.ONLINE
                && desk.self().session().compareTo(presence.sender().session()) > 0) {
            active = false;
            withdraw.accept(taken());
        } else {
            publish();
        }
    }

    /** Publishes that the desk is there, with its robots. */
    void publish() {
        if (active) {
            desk.publish(message(State.ONLINE, robots.get()));
        }
    }

    /** Publishes the robots if they have changed, and before the broker forgets them. */
    void publishChange() {
        boolean due = desk.connection().time().secondsSince(publishedNanos) >= RENEWAL_S;
        if (active && (due || !robots.get().equals(published))) {
            publish();
        }
    }

    /** Publishes that the desk has ended, unless it had no right to its name. */
    void end() {
        if (active) {
            active = false;
            desk.publish(message(State.OFFLINE, List.of()));
        }
    }

    boolean isActive() {
        return active;
    }

    private BrokerMessage message(State state, List<Integer> numbers) {
        published = numbers;
        publishedNanos = desk.connection().time().nanos();
        Presence presence = new Presence(state, desk.self(), program, numbers);
        return BrokerMessage.json(desk.topics().presence(desk.self().desk()), presence.toJson(), Quality.AT_LEAST_ONCE)
                .retain()
                .expiringAfter(EXPIRY_S);
    }
}
