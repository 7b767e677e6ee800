package majic.shared;

import java.util.OptionalLong;
import java.util.function.Consumer;
import majic.bot.BotException;
import majic.driver.RobotWait;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.PublicationRefused;
import majic.shared.broker.Quality;
import majic.shared.message.HoldMessage;
import majic.shared.message.Request;
import majic.shared.message.RequestedAction;
import majic.shared.message.SiteTopics;
import majic.shared.message.SiteTopics.Part;
import majic.shared.message.SpeedMessage;
import majic.shared.message.StopMessage;
import org.jspecify.annotations.Nullable;

/**
 * Publishes what moves, stops and asks one shared robot. Everything that may move it is valid for a short time on the
 * clock of the desk that has it, so that nothing moves a robot that arrives late. No method blocks; all throw a
 * {@link BotException} while there is no connection to the broker. Thread-safe.
 */
final class RobotCommands {
    private static final long REQUEST_MS = 1000;
    private static final long SPEED_MS = 500;
    private static final long HEARTBEAT_MS = 700;
    private static final int REQUEST_EXPIRY_S = 2;

    /** The desk sends scans for 4 s after each request. */
    private static final double SCANS_S = 1;

    private final PooledBroker broker;
    private final SharedAddress address;
    private final SiteTopics topics;
    private final RobotFeed feed;
    private final RobotWait waiting;
    private volatile long scansAskedNanos;

    /**
     * Publishes to one robot.
     *
     * @param feed provides the clock of the desk
     * @param waiting is woken by each answer
     */
    RobotCommands(PooledBroker broker, SharedAddress address, RobotFeed feed, RobotWait waiting) {
        this.broker = broker;
        this.address = address;
        this.topics = new SiteTopics(address.broker().site());
        this.feed = feed;
        this.waiting = waiting;
        this.scansAskedNanos = waiting.time().nanos() - Math.round(SCANS_S * 1e9);
    }

    /** Publishes a request, whose answers are collected until {@link #forget}. */
    PendingReply request(RequestedAction action) {
        Request request = next(action);
        BrokerMessage message = BrokerMessage.json(topic(Part.REQUEST), request.toJson(), Quality.AT_LEAST_ONCE)
                .expiringAfter(REQUEST_EXPIRY_S);
        return ask(message, String.valueOf(request.number()));
    }

    private Request next(RequestedAction action) {
        return new Request(broker.sender(), broker.nextNumber(), OptionalLong.of(feed.deskClockIn(REQUEST_MS)), action);
    }

    /** Asks for scans if that was not done within the last second; expects no answer. */
    void keepScans() {
        if (waiting.time().secondsSince(scansAskedNanos) >= SCANS_S) {
            scansAskedNanos = waiting.time().nanos();
            publish(Part.REQUEST, next(new RequestedAction.Scans()).toJson(), problem -> {});
        }
    }

    /** Expects no further answer to a request. */
    void forget(PendingReply reply) {
        broker.forget(reply);
    }

    /** Expects the refusals of one drive, until {@link #forget}. */
    PendingReply expectDrive() {
        return broker.expect("drive-" + broker.nextNumber(), waiting);
    }

    /**
     * Publishes the speeds for the next 600 ms.
     *
     * @param drive takes the answer if they are refused
     */
    void drive(double mmPerSec, double degPerSec, PendingReply drive) {
        SpeedMessage speed =
                new SpeedMessage(broker.sender(), broker.nextNumber(), mmPerSec, degPerSec, feed.deskClockIn(SPEED_MS));
        broker.publish(BrokerMessage.json(topic(Part.SPEED), speed.toJson(), Quality.AT_MOST_ONCE), topics, drive);
    }

    /**
     * Publishes the heartbeat of the holder.
     *
     * @param refused receives the reason if the broker refuses it, on any thread; must not wait
     */
    void heartbeat(Consumer<PublicationRefused> refused) {
        HoldMessage hold = new HoldMessage(broker.sender(), feed.deskClockIn(HEARTBEAT_MS));
        publish(Part.HOLD, hold.toJson(), problem -> {
            if (problem instanceof PublicationRefused refusal) {
                refused.accept(refusal);
            }
        });
    }

    /** Publishes a stop by the fastest way; the second copy is answered, also by a refusal. */
    void stopAhead(String id) {
        publish(Part.STOP, stop(id), problem -> {});
    }

    /** Publishes a stop that is delivered for certain and answered. */
    PendingReply stopConfirmed(String id) {
        BrokerMessage message = BrokerMessage.json(topic(Part.STOP), stop(id), Quality.AT_LEAST_ONCE);
        return ask(message, "stop-" + id);
    }

    private PendingReply ask(BrokerMessage message, String correlation) {
        PendingReply reply = broker.expect(correlation, waiting);
        try {
            broker.publish(message, topics, reply);
            return reply;
        } catch (RuntimeException e) {
            broker.forget(reply);
            throw e;
        }
    }

    private byte[] stop(String id) {
        return new StopMessage(broker.sender(), broker.lastNumber(), id).toJson();
    }

    private void publish(Part part, byte[] json, Consumer<@Nullable BotException> outcome) {
        broker.connection().publish(BrokerMessage.json(topic(part), json, Quality.AT_MOST_ONCE), outcome);
    }

    private String topic(Part part) {
        return topics.robot(address.desk(), address.robot(), part);
    }

    /** Returns whether the robot cannot be used any more. */
    boolean isOver() {
        return feed.isOver();
    }
}
