package majic.figures;

import java.nio.charset.StandardCharsets;
import java.util.concurrent.atomic.AtomicLong;
import majic.environment.BotEnvironment;
import majic.shared.broker.BrokerAddress;
import majic.shared.broker.BrokerConnection;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.ConnectOptions;
import majic.shared.broker.Quality;

/** What a broker has received and sent since its start, as it publishes it once a second. */
final class BrokerBytes {
    private static final String TOPIC = "$SYS/broker/bytes/";

    private final AtomicLong received = new AtomicLong();
    private final AtomicLong sent = new AtomicLong();

    BrokerBytes(BrokerAddress broker) {
        BrokerConnection connection = BrokerConnection.open(broker, ConnectOptions.of("bytes", BotEnvironment.plain()));
        connection.connect();
        connection.subscribe(TOPIC + "received", Quality.AT_MOST_ONCE, message -> set(received, message));
        connection.subscribe(TOPIC + "sent", Quality.AT_MOST_ONCE, message -> set(sent, message));
    }

    private static void set(AtomicLong count, BrokerMessage message) {
        count.set(Long.parseLong(new String(message.payload(), StandardCharsets.US_ASCII)));
    }

    long received() {
        return received.get();
    }

    long sent() {
        return sent.get();
    }
}
