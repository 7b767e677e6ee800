package majic.ros.bridge;

import com.fasterxml.jackson.databind.JsonNode;

/** One subscription to a topic, until it is closed or the connection ends. Thread-safe. */
public final class RosSubscription implements AutoCloseable {
    private final TopicStream stream;
    private final TopicSubscription wanted;
    private final MessageReceiver onMessage;

    RosSubscription(TopicStream stream, TopicSubscription wanted, MessageReceiver onMessage) {
        this.stream = stream;
        this.wanted = wanted;
        this.onMessage = onMessage;
    }

    TopicSubscription wanted() {
        return wanted;
    }

    void receive(JsonNode message, int bytes) {
        onMessage.message(message, bytes);
    }

    /**
     * Returns the topic.
     *
     * @return its absolute name
     */
    public String topic() {
        return wanted.topic();
    }

    /**
     * Returns how many messages the topic's stream has had on this connection.
     *
     * @return 0 or more
     */
    public long count() {
        return stream.count();
    }

    /**
     * Returns the age of the newest message.
     *
     * @return seconds since its arrival; positive infinity before the first one
     */
    public double ageS() {
        return stream.ageS();
    }

    /**
     * Ends the subscription; the last one of a topic ends its stream. A message may still be handled during the call.
     */
    @Override
    public void close() {
        stream.remove(this);
    }
}
