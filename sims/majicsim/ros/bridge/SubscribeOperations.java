package majicsim.ros.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import majicsim.ros.message.MessageMismatch;

/** subscribe and unsubscribe of one client (sheet 3). */
final class SubscribeOperations {
    private static final long NANOS_PER_MS = 1_000_000;

    private final Peer peer;
    private final Subscribers subscribers;

    SubscribeOperations(Peer peer, Subscribers subscribers) {
        this.peer = peer;
        this.subscribers = subscribers;
    }

    void subscribe(JsonNode message) throws MessageMismatch {
        String topic = Fields.text(message, "topic");
        String type = message.has("type") ? Fields.text(message, "type") : null;
        SubscriptionWish wish = new SubscriptionWish(
                Fields.number(message, "throttle_rate", 0) * NANOS_PER_MS,
                Fields.number(message, "queue_length", 0),
                message.path("compression").asText("none"));
        subscribers.subscribe(peer, topic, type, Fields.id(message), wish);
    }

    void unsubscribe(JsonNode message) throws MessageMismatch {
        String id = message.has("id") ? Fields.id(message) : null;
        subscribers.unsubscribe(peer, Fields.text(message, "topic"), id);
    }
}
