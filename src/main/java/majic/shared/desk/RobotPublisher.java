package majic.shared.desk;

import java.util.List;
import java.util.Objects;
import java.util.function.Supplier;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.Quality;
import majic.shared.message.Description;
import majic.shared.message.RobotState;
import majic.shared.message.SiteTopics.Part;
import majic.shared.message.StateChange;
import majic.team.Member;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * Publishes what one robot is and does: its state at once when a condition has changed and once a second, and in
 * between, at most ten times a second, what has changed in its reports. While another program holds the robot,
 * something is published every 250 ms, with which the holder can answer by a heartbeat. Thread-safe.
 */
final class RobotPublisher {
    /** The time between two changes of a robot that reports all the time, seconds. */
    private static final double SHORTEST_S = 0.1;

    /** The time between two states, seconds: a sign of life, and it replaces changes that were lost. */
    private static final double LONGEST_S = 1;

    /** The same for a held robot, with or without news: the holder's heartbeats may be answers to this, seconds. */
    private static final double HELD_S = 0.25;

    /** A state that was kept by the broker is not used for longer than this, seconds. */
    private static final int EXPIRY_S = 3;

    private final DeskContext desk;
    private final Member member;
    private final Supplier<@Nullable RobotHold> hold;
    private volatile boolean changed = true;
    private volatile boolean reported;
    private volatile boolean moving;
    private volatile long sampledNanos;
    private volatile long publishedNanos;
    /** When the desk's clock was last published, in a state or a change. */
    private volatile long clockNanos;

    /** As it is for a program that has received all states and changes. */
    private @Nullable RobotState published;

    private long describedNanos;
    private long renewedNanos;
    private @Nullable Description described;
    private boolean ended;

    RobotPublisher(DeskContext desk, Member member, Supplier<@Nullable RobotHold> hold) {
        this.desk = desk;
        this.member = member;
        this.hold = hold;
        this.publishedNanos = desk.connection().time().nanos();
        this.sampledNanos = publishedNanos;
        this.clockNanos = publishedNanos;
    }

    /** A condition has changed: the state is published at once. */
    void changed() {
        changed = true;
        desk.wake().run();
    }

    /** The robot has reported something; called on its listener thread. */
    void reported(boolean isMoving) {
        reported = true;
        if (isMoving != moving) {
            moving = isMoving;
            changed();
        }
    }

    /** Publishes everything anew: the broker may have lost what it kept. */
    void repeat() {
        synchronized (this) {
            described = null;
        }
        changed();
    }

    /** Publishes what is due. Called by the timer of the desk. */
    void tick() {
        TimeSource time = desk.connection().time();
        if (changed || time.secondsSince(publishedNanos) >= LONGEST_S) {
            publishState();
        } else if (hold.get() != null && time.secondsSince(clockNanos) >= HELD_S) {
            publishNews(true);
        } else if (reported && time.secondsSince(sampledNanos) >= SHORTEST_S) {
            publishNews(false);
        }
    }

    /**
     * Publishes what has changed. A robot that repeats the same values all the time costs no more of the network than
     * one that is silent.
     *
     * @param always also if only the clock has changed
     */
    private synchronized void publishNews(boolean always) {
        sampledNanos = desk.connection().time().nanos();
        reported = false;
        RobotState before = published;
        RobotState present = present();
        if (before == null || !present.hasConditionsOf(before)) {
            publish(present);
        } else {
            StateChange change = StateChange.between(before, present);
            if (always || !change.isEmpty()) {
                publish(change, present);
            }
        }
    }

    private void publish(StateChange change, RobotState present) {
        if (!ended && desk.publish(BrokerMessage.json(topic(Part.CHANGES), change.toJson(), Quality.AT_MOST_ONCE))) {
            clockNanos = desk.connection().time().nanos();
            published = present;
        }
    }

    /** Publishes the present state, and the description if it has changed. Called on any thread. */
    synchronized void publishState() {
        sampledNanos = desk.connection().time().nanos();
        changed = false;
        reported = false;
        publish(present());
    }

    private RobotState present() {
        return RobotStates.state(
                member,
                desk.self(),
                desk.clock().ms(),
                desk.team().isLatched(),
                desk.team().stops().of(List.of(member.number())),
                hold.get(),
                desk.team().stopStatus().problem(member.number()));
    }

    private void publish(RobotState state) {
        publishedNanos = desk.connection().time().nanos();
        clockNanos = publishedNanos;
        if (ended || !desk.connection().isConnected()) {
            return;
        }
        describe();
        published = state;
        desk.publish(BrokerMessage.json(topic(Part.STATE), state.toJson(), Quality.AT_MOST_ONCE)
                .retain()
                .expiringAfter(EXPIRY_S));
    }

    /** Connecting may change what a robot offers; looked at once a second at most. */
    private void describe() {
        long now = desk.connection().time().nanos();
        if (described != null && (now - describedNanos) / 1e9 < LONGEST_S) {
            return;
        }
        describedNanos = now;
        Description present = RobotStates.description(member, desk.self());
        boolean due = (now - renewedNanos) / 1e9 >= DeskPresence.RENEWAL_S;
        if ((due || !Objects.equals(present, described))
                && desk.publish(BrokerMessage.json(topic(Part.DESCRIPTION), present.toJson(), Quality.AT_LEAST_ONCE)
                        .retain()
                        .expiringAfter(DeskPresence.EXPIRY_S))) {
            described = present;
            renewedNanos = now;
        }
    }

    /** Removes what the broker keeps of the robot, and publishes no more. */
    synchronized void end() {
        ended = true;
        desk.publish(BrokerMessage.removing(topic(Part.STATE)));
        desk.publish(BrokerMessage.removing(topic(Part.DESCRIPTION)));
    }

    private String topic(Part part) {
        return desk.topics().robot(desk.self().desk(), member.number(), part);
    }
}
