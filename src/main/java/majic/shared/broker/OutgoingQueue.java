package majic.shared.broker;

import com.hivemq.client.mqtt.mqtt5.Mqtt5RxClient;
import com.hivemq.client.mqtt.mqtt5.message.publish.Mqtt5Publish;
import io.reactivex.disposables.Disposable;
import io.reactivex.processors.FlowableProcessor;
import io.reactivex.processors.UnicastProcessor;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import majic.bot.BotException;
import org.jspecify.annotations.Nullable;

/**
 * The messages of one session that the broker has not got yet. Adding one never blocks, which a call of the client
 * library for each message would do once some dozens are unacknowledged. Thread-safe.
 */
final class OutgoingQueue {
    /** Of messages that may be lost. */
    private static final long MOST_BYTES = 4 << 20;

    /** Of all messages. Stops are small and rare; there is always room for them. */
    private static final long LIMIT_BYTES = 64 << 20;

    /** Of more topics the broker need not answer the first message: others choose the topics of their answers. */
    private static final int MOST_TOPICS = 20_000;

    private final FlowableProcessor<Mqtt5Publish> queue =
            UnicastProcessor.<Mqtt5Publish>create().toSerialized();
    private final Map<Mqtt5Publish, Consumer<@Nullable Throwable>> pending = new IdentityHashMap<>();
    private final Set<String> topics = new HashSet<>();
    private long bytes;
    private @Nullable Throwable end;
    private @Nullable Disposable results;

    /** Begins to send; to be called once, when the broker has accepted the client. */
    void begin(Mqtt5RxClient client) {
        results = client.publish(queue)
                .subscribe(result -> done(result.getPublish(), result.getError().orElse(null)), this::end);
    }

    /**
     * Adds a message.
     *
     * @param outcome called once: with null when the message is acknowledged or written, otherwise with the reason
     * @throws BotException if the connection is too slow for what is published, or has ended; the message is not sent
     */
    void add(BrokerMessage message, Consumer<@Nullable Throwable> outcome) {
        Mqtt5Publish publish;
        synchronized (this) {
            if (end != null) {
                throw new BotException("the connection with the broker has ended", end);
            }
            if (bytes > (message.quality() == Quality.AT_MOST_ONCE ? MOST_BYTES : LIMIT_BYTES)) {
                throw new BotException("the network or the broker is too slow: " + (bytes >> 20)
                        + " MB wait to be sent; the message on " + message.topic() + " is dropped");
            }
            publish = HiveMessages.publish(answerable(message));
            bytes += message.payload().length;
            pending.put(publish, outcome);
        }
        queue.onNext(publish);
    }

    /** The first message on a topic is sent so that the broker has to answer; the answer is that to all of them. */
    private BrokerMessage answerable(BrokerMessage message) {
        boolean first = topics.size() < MOST_TOPICS && topics.add(message.topic());
        return first ? message.withQuality(Quality.AT_LEAST_ONCE) : message;
    }

    private void done(Mqtt5Publish publish, @Nullable Throwable failure) {
        Consumer<@Nullable Throwable> outcome;
        synchronized (this) {
            outcome = pending.remove(publish);
            if (outcome != null) {
                bytes -= publish.getPayloadAsBytes().length;
            }
        }
        if (outcome != null) {
            outcome.accept(failure);
        }
    }

    /** Ends the queue with its session: the outcome of what is in it is this reason. */
    void end(Throwable reason) {
        List<Consumer<@Nullable Throwable>> unsent;
        synchronized (this) {
            if (end != null) {
                return;
            }
            end = reason;
            unsent = new ArrayList<>(pending.values());
            pending.clear();
        }
        unsent.forEach(outcome -> outcome.accept(reason));
        Disposable sending = results;
        if (sending != null) {
            sending.dispose();
        }
    }
}
