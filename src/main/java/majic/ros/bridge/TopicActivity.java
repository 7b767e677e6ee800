package majic.ros.bridge;

/**
 * What has arrived of a topic that is subscribed to. Immutable.
 *
 * @param topic its absolute name
 * @param type as it was subscribed to; may be empty
 * @param count messages on this connection, 0 or more
 * @param ageS since the newest message, s; positive infinity before the first one
 */
public record TopicActivity(String topic, String type, long count, double ageS) {}
