package majic.figures;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import majic.environment.BotEnvironment;
import majic.shared.broker.BrokerAddress;
import majic.shared.broker.BrokerConnection;
import majic.shared.broker.BrokerConnections;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.ConnectOptions;
import majic.shared.broker.Quality;

/** Messages from one connection to another through the broker, with nothing else to do: what commands are compared with. */
final class BareMessages implements AutoCloseable {
    private final String topic;
    private final BrokerConnection sender;
    private final BrokerConnection receiver;
    private final Quality quality;
    private final List<Double> times = Collections.synchronizedList(new ArrayList<>());

    BareMessages(BrokerAddress broker, Quality quality) {
        this.quality = quality;
        topic = broker.site() + "/bare/" + quality;
        sender = BrokerConnections.open(broker, ConnectOptions.of("bare-sender-" + quality, BotEnvironment.plain()));
        receiver =
                BrokerConnections.open(broker, ConnectOptions.of("bare-receiver-" + quality, BotEnvironment.plain()));
        sender.connect();
        receiver.connect();
        receiver.subscribe(topic, quality, this::received);
    }

    private void received(BrokerMessage message) {
        times.add((System.nanoTime() - ByteBuffer.wrap(message.payload()).getLong()) / 1e6);
    }

    /** Sends one of a size in bytes. */
    void send(int size) {
        ByteBuffer payload = ByteBuffer.allocate(size);
        payload.putLong(System.nanoTime());
        sender.publish(BrokerMessage.json(topic, payload.array(), quality));
    }

    /** Forgets those so far. */
    void reset() {
        times.clear();
    }

    /** Returns the times from sending to receiving, ms. */
    List<Double> times() {
        synchronized (times) {
            return List.copyOf(times);
        }
    }

    @Override
    public void close() {
        sender.close();
        receiver.close();
    }
}
