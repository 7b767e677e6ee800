package majic.shared.broker;

import java.nio.charset.StandardCharsets;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * One message of a broker. The arrays are not copied and must not be changed.
 *
 * @param topic where it is published, without wildcards
 * @param payload its content; empty to remove a retained message
 * @param quality the quality of service it is sent with
 * @param retained in a message to send, whether the broker keeps it for later subscribers; in a received one, whether
 *     it was kept: it was published before the subscription
 * @param responseTopic where the answer is expected; null for none
 * @param correlation what the answer has to repeat; null for none
 * @param expirySeconds after how many seconds the broker drops it instead of delivering it; 0 for never
 * @param contentType the kind of content, such as {@code application/json}; empty if it is not given
 */
public record BrokerMessage(
        String topic,
        byte[] payload,
        Quality quality,
        boolean retained,
        @Nullable String responseTopic,
        byte @Nullable [] correlation,
        int expirySeconds,
        String contentType) {

    /** The content type of JSON. */
    public static final String JSON = "application/json";

    /**
     * Checks the parts that every message has.
     *
     * @throws IllegalArgumentException if the topic is empty or contains a wildcard, or the expiry is negative
     */
    public BrokerMessage {
        if (topic.isEmpty() || topic.contains("+") || topic.contains("#")) {
            throw new IllegalArgumentException("not the topic of a message: " + topic);
        }
        if (expirySeconds < 0) {
            throw new IllegalArgumentException("a message expires after 1 s or later, or never: " + expirySeconds);
        }
        Objects.requireNonNull(payload, "payload");
        Objects.requireNonNull(quality, "quality");
        Objects.requireNonNull(contentType, "content type");
    }

    /**
     * Creates a message that is not retained, does not expire and asks for no answer.
     *
     * @param topic where it is published
     * @param text its content, sent as UTF-8
     * @param quality the quality of service
     * @return the message, with the content type of JSON
     */
    public static BrokerMessage json(String topic, String text, Quality quality) {
        return json(topic, text.getBytes(StandardCharsets.UTF_8), quality);
    }

    /**
     * Creates a message that is not retained, does not expire and asks for no answer.
     *
     * @param topic where it is published
     * @param json its content, UTF-8
     * @param quality the quality of service
     * @return the message, with the content type of JSON
     */
    public static BrokerMessage json(String topic, byte[] json, Quality quality) {
        return new BrokerMessage(topic, json, quality, false, null, null, 0, JSON);
    }

    /**
     * Creates the message that removes a retained one.
     *
     * @param topic of the retained message
     * @return a retained message without content
     */
    public static BrokerMessage removing(String topic) {
        return new BrokerMessage(topic, new byte[0], Quality.AT_LEAST_ONCE, true, null, null, 0, "");
    }

    /**
     * Returns the same message, which the broker keeps for later subscribers.
     *
     * @return a retained message
     */
    public BrokerMessage retain() {
        return withRetained(true);
    }

    BrokerMessage withRetained(boolean kept) {
        return new BrokerMessage(topic, payload, quality, kept, responseTopic, correlation, expirySeconds, contentType);
    }

    BrokerMessage withQuality(Quality other) {
        return new BrokerMessage(
                topic, payload, other, retained, responseTopic, correlation, expirySeconds, contentType);
    }

    /**
     * Returns the same message, which the broker drops after a time.
     *
     * @param seconds at least 1
     * @return a message that expires
     */
    public BrokerMessage expiringAfter(int seconds) {
        return new BrokerMessage(topic, payload, quality, retained, responseTopic, correlation, seconds, contentType);
    }

    /**
     * Returns the same message, which asks for an answer.
     *
     * @param answerTopic where the answer is expected
     * @param answerCorrelation what the answer has to repeat
     * @return a request
     */
    public BrokerMessage answeredAt(String answerTopic, byte[] answerCorrelation) {
        return new BrokerMessage(
                topic, payload, quality, retained, answerTopic, answerCorrelation, expirySeconds, contentType);
    }

    /**
     * Returns the answer to this message.
     *
     * @param content of the answer
     * @param type its content type
     * @return a message to the response topic with the same correlation data
     * @throws IllegalStateException if this message asks for no answer
     */
    public BrokerMessage answer(byte[] content, String type) {
        if (responseTopic == null) {
            throw new IllegalStateException("the message on " + topic + " asks for no answer");
        }
        return new BrokerMessage(responseTopic, content, Quality.AT_LEAST_ONCE, false, null, correlation, 0, type);
    }

    /**
     * Returns the content as text.
     *
     * @return the payload read as UTF-8; malformed bytes become the replacement character
     */
    public String text() {
        return new String(payload, StandardCharsets.UTF_8);
    }
}
