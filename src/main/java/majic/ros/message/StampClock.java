package majic.ros.message;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.OptionalDouble;

/**
 * Estimates when the messages of one topic were measured, by the stamps in their headers. These are of the robot's
 * clock, which need not agree with this computer's and may be set: only their differences count. The message that came
 * fastest so far is taken to have been under way for half of the shortest round trip, the others for longer by what
 * they lag behind it. Times are on the driver's clock, which is an argument. Used by one thread.
 */
public final class StampClock {
    /** The lag of the fastest message is forgotten at this rate: the clock of a microcontroller drifts by so much. */
    private static final double DRIFT = 0.02;

    /**
     * What a message may be older than the round trip, which includes what waits for the connection, seconds: beyond it
     * the stamp is doubtful.
     */
    private static final double LONGEST_WAIT_S = 0.5;

    private final boolean isTrusted;
    private double leastLagS = Double.POSITIVE_INFINITY;
    private double leastRoundTripS = Double.POSITIVE_INFINITY;
    private double lastStampS = Double.NEGATIVE_INFINITY;
    private double lastAgeS;
    private long lastNanos;
    private long newestNanos = Long.MIN_VALUE;

    /**
     * Begins with the first message.
     *
     * @param isTrusted false for stamps of a simulated time, which passes at another rate: messages are then taken as
     *     measured when they arrive
     */
    public StampClock(boolean isTrusted) {
        this.isTrusted = isTrusted;
    }

    /**
     * Takes a message.
     *
     * @param message any; one without a stamp is taken as measured when it arrives
     * @param arrivedNanos when it arrived
     * @param roundTripS of the connection at present, s; 0 if that is not known
     * @return when it was measured; not before the message before it
     */
    public long measuredNanos(JsonNode message, long arrivedNanos, double roundTripS) {
        OptionalDouble stamp = stampS(message);
        if (!isTrusted || stamp.isEmpty()) {
            return arrivedNanos;
        }
        if (roundTripS > 0) {
            leastRoundTripS = Math.min(leastRoundTripS, roundTripS);
        }
        double underWayS = Double.isFinite(leastRoundTripS) ? leastRoundTripS / 2 : 0;
        double sinceLastS = (arrivedNanos - lastNanos) / 1e9;
        double lagS = arrivedNanos / 1e9 - stamp.getAsDouble();
        if (stamp.getAsDouble() < lastStampS) {
            // The robot's clock was set back: the message is as old as the one before.
            leastLagS = lagS - lastAgeS;
        }
        leastLagS = Math.min(lagS, leastLagS + DRIFT * Math.max(0, sinceLastS));
        lastStampS = stamp.getAsDouble();
        lastAgeS = lagS - leastLagS;
        lastNanos = arrivedNanos;
        double ageS = Math.min(lastAgeS + underWayS, roundTripS + LONGEST_WAIT_S);
        newestNanos = Math.max(newestNanos, arrivedNanos - (long) (ageS * 1e9));
        return newestNanos;
    }

    private static OptionalDouble stampS(JsonNode message) {
        JsonNode stamp = Fields.at(message, "header.stamp");
        double seconds = stamp.path("sec").asDouble(stamp.path("secs").asDouble());
        double nanos = stamp.path("nanosec").asDouble(stamp.path("nsecs").asDouble());
        return seconds > 0 ? OptionalDouble.of(seconds + nanos / 1e9) : OptionalDouble.empty();
    }
}
