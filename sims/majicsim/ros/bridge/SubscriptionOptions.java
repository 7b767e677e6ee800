package majicsim.ros.bridge;

/**
 * What a client asked for with one subscription.
 *
 * @param throttleNanos the shortest time between two messages; 0 for all of them
 * @param queueLength how many of the newest messages wait; 0 for no queue
 * @param compression none, png, cbor
 */
record SubscriptionOptions(long throttleNanos, int queueLength, String compression) {
    /** Several subscriptions of a client to a topic are one stream with the least of all values (sheet 3). */
    SubscriptionOptions merged(SubscriptionOptions other) {
        return new SubscriptionOptions(
                Math.min(throttleNanos, other.throttleNanos),
                Math.min(queueLength, other.queueLength),
                rank(compression) >= rank(other.compression) ? compression : other.compression);
    }

    private static int rank(String compression) {
        return switch (compression) {
            case "cbor" -> 2;
            case "png" -> 1;
            default -> 0;
        };
    }
}
