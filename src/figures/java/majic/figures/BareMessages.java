package majic.figures;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import majic.environment.BotEnvironment;
import majic.shared.broker.BrokerAddress;
import majic.shared.broker.BrokerConnection;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.ConnectOptions;

/**
 * Messages from one connection to another through the broker, with nothing else to do: what commands are compared with.
 * They have the size of a command, in the topic, the content and the response topic, and its quality of service.
 */
final class BareMessages implements AutoCloseable {
    private final BrokerMessage command;
    private final BrokerConnection sender;
    private final BrokerConnection receiver;
    private final List<Double> times = Collections.synchronizedList(new ArrayList<>());

    /**
     * Connects.
     *
     * @param like a command to a robot, whose topic nothing else subscribes to
     */
    BareMessages(BrokerAddress broker, BrokerMessage like) {
        command = like;
        sender = open(broker, "bare-sender-" + like.quality());
        receiver = open(broker, "bare-receiver-" + like.quality());
        receiver.subscribeUrgently(like.topic(), like.quality(), this::received);
    }

    private static BrokerConnection open(BrokerAddress broker, String client) {
        BrokerConnection opened = BrokerConnection.open(broker, ConnectOptions.of(client, BotEnvironment.plain()));
        opened.connect();
        return opened;
    }

    private void received(BrokerMessage message) {
        times.add((System.nanoTime() - ByteBuffer.wrap(message.payload()).getLong()) / 1e6);
    }

    /** Sends one. */
    void send() {
        ByteBuffer payload = ByteBuffer.allocate(command.payload().length);
        payload.putLong(System.nanoTime());
        sender.publish(new BrokerMessage(
                command.topic(),
                payload.array(),
                command.quality(),
                false,
                command.responseTopic(),
                command.correlation(),
                command.expirySeconds(),
                command.contentType()));
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
