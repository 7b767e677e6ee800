package majic.shared.message;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.stream.IntStream;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;

/**
 * What a range sensor of a shared robot has measured. Immutable.
 *
 * @param clock when it was written, ms of the clock of the desk that has the robot
 * @param ageMs since it was measured
 * @param sensor the name of the sensor in the description of the robot
 * @param odometry the pose of the robot's centre when it was measured, in the frame of its odometry
 * @param rangesMm a distance for each beam; {@link #NO_ECHO} or {@link #NOTHING_MEASURED} instead of one
 */
public record ScanMessage(long clock, long ageMs, String sensor, Pose odometry, List<Integer> rangesMm) {
    /** There was no echo up to the reach of the beam. */
    public static final int NO_ECHO = -1;

    /** Nothing was measured. */
    public static final int NOTHING_MEASURED = -2;

    private static final String WHAT = "scan";
    private static final String RANGES = "ranges";
    private static final int MOST_BYTES = 128 * 1024;

    /** Rounds the pose, and keeps a copy of the distances. */
    public ScanMessage {
        odometry = RobotState.rounded(odometry);
        rangesMm = List.copyOf(rangesMm);
    }

    /**
     * Describes a scan.
     *
     * @param clock when it is written, ms of the clock of the desk
     * @param ageMs since it was measured
     * @param scan of a sensor of the robot
     * @return the message
     */
    public static ScanMessage of(long clock, long ageMs, RangeScan scan) {
        List<Integer> ranges = IntStream.range(0, scan.size())
                .mapToObj(beam -> range(scan.rangeMm(beam)))
                .toList();
        return new ScanMessage(clock, ageMs, scan.sensor().name(), scan.odometry(), ranges);
    }

    private static int range(float mm) {
        return Float.isNaN(mm) ? NOTHING_MEASURED : Float.isInfinite(mm) ? NO_ECHO : Math.round(mm);
    }

    /**
     * Returns the scan.
     *
     * @param described the sensor of this name, as the robot is described
     * @param timeS when it was measured, on the clock of this program
     * @return the scan
     * @throws UnusableMessageException if the sensor has another number of beams
     */
    public RangeScan scan(RangeSensor described, double timeS) {
        if (rangesMm.size() != described.beams().size()) {
            throw new UnusableMessageException(WHAT + ": it has " + rangesMm.size() + " distances; the sensor has "
                    + described.beams().size() + " beams");
        }
        float[] ranges = new float[rangesMm.size()];
        for (int beam = 0; beam < ranges.length; beam++) {
            int mm = rangesMm.get(beam);
            ranges[beam] = mm >= 0 ? mm : mm == NO_ECHO ? Float.POSITIVE_INFINITY : Float.NaN;
        }
        return new RangeScan(described, timeS, odometry, ranges);
    }

    /**
     * Writes the message.
     *
     * @return JSON in UTF-8
     */
    public byte[] toJson() {
        ObjectNode json =
                JsonObject.create().put("clock", clock).put("age", ageMs).put("sensor", sensor);
        JsonObject.put(json, "odometry", odometry);
        ArrayNode ranges = json.putArray(RANGES);
        rangesMm.forEach(mm -> ranges.add(mm));
        return JsonObject.bytes(json);
    }

    /**
     * Reads a message.
     *
     * @param payload JSON in UTF-8
     * @return the scan
     * @throws UnusableMessageException if it is none
     */
    public static ScanMessage parse(byte[] payload) {
        JsonObject json = JsonObject.parse(WHAT, payload, MOST_BYTES);
        return new ScanMessage(
                json.whole("clock"),
                json.whole("age", 0),
                json.text("sensor"),
                json.pose("odometry"),
                json.list(RANGES, item -> range(json, item)));
    }

    private static int range(JsonObject json, JsonNode item) {
        if (!item.isInt() || item.intValue() < NOTHING_MEASURED) {
            throw json.wrong(RANGES, "each is a whole number of mm, -1 for no echo, -2 for nothing measured");
        }
        return item.intValue();
    }
}
