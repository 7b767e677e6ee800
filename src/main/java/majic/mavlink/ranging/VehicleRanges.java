package majic.mavlink.ranging;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.IntStream;
import majic.bot.Beam;
import majic.bot.Pose;
import majic.bot.RangeSensor;
import majic.bot.Unit;
import majic.bot.Value;
import majic.mavlink.message.ObstacleRing;
import majic.mavlink.message.RangeReading;
import majic.mavlink.session.Received;
import majic.mavlink.session.VehicleReports;
import majic.time.TimeSource;

/**
 * The newest distances of one vehicle. Where on the vehicle its sensors are is not reported: they are taken to be in
 * its middle, so that the distance to the hull is rather too short than too long. Thread-safe.
 */
public final class VehicleRanges {
    /** A reading that is older counts as none, seconds: the vehicle has moved on. */
    private static final double OLD_S = 0.6;

    /** The opening of a range finder, degrees: it is rarely reported. */
    private static final double OPENING_DEG = 10;

    private static final double NOISE_MM = 30;
    private static final Value NONE = Value.unknown("no sensor looks there");
    private static final Value NO_READING = Value.unknown("nothing measured there");

    private final VehicleReports reports;
    private final TimeSource time;
    private final Map<String, RangeSensor> sensors = new ConcurrentHashMap<>();

    /** A distance of one beam. */
    private record Seen(double directionDeg, double mm) {}

    /** Reads what arrives in a session. */
    public VehicleRanges(VehicleReports reports, TimeSource time) {
        this.reports = reports;
        this.time = time;
    }

    /** Whether anything measures. */
    public boolean areThere() {
        return !reports.ranges().isEmpty() || reports.newest(ObstacleRing.class).isPresent();
    }

    /** Returns the sensors that have reported so far. */
    public List<RangeSensor> sensors() {
        List<RangeSensor> all = new ArrayList<>();
        reports.ranges().values().stream()
                .map(Received::value)
                .filter(RangeReading::isHorizontal)
                .forEach(reading -> all.add(sensor(reading)));
        reports.newest(ObstacleRing.class)
                .map(Received::value)
                .filter(ObstacleRing::isUsable)
                .ifPresent(ring -> all.add(sensor(ring)));
        return all;
    }

    /** Returns the sensor that has made a reading; the same object for the same sensor. */
    public RangeSensor sensor(RangeReading reading) {
        Beam beam = new Beam(
                new Pose(0, 0, reading.directionDeg()), OPENING_DEG, reading.leastMm(), reading.mostMm(), NOISE_MM);
        return same(new RangeSensor("range" + reading.id(), List.of(beam)));
    }

    /** Returns the sensor that has made a ring; the same object for the same sensor. */
    public RangeSensor sensor(ObstacleRing ring) {
        double opening = Math.min(Math.abs(ring.stepDeg()), OPENING_DEG);
        return same(new RangeSensor(
                "obstacles",
                IntStream.range(0, ObstacleRing.COUNT)
                        .mapToObj(index -> new Beam(
                                new Pose(0, 0, ring.firstDeg() + index * ring.stepDeg()),
                                opening,
                                ring.leastMm(),
                                ring.mostMm(),
                                NOISE_MM))
                        .toList()));
    }

    private RangeSensor same(RangeSensor sensor) {
        return sensors.merge(sensor.name(), sensor, (known, now) -> known.equals(now) ? known : now);
    }

    /** Returns the distances of a ring in the order of its beams, mm. */
    public float[] ranges(ObstacleRing ring) {
        float[] ranges = new float[ObstacleRing.COUNT];
        for (int index = 0; index < ranges.length; index++) {
            ranges[index] = (float) ring.mm(index);
        }
        return ranges;
    }

    /**
     * Returns the distance from the hull to the nearest thing on a side.
     *
     * @param radiusMm of the hull
     * @return mm, clear, or unknown with the reason
     */
    public Value gap(HullGap side, double radiusMm) {
        List<Seen> seen = new ArrayList<>();
        boolean looks = addRangeFinders(side, seen) | addRing(side, seen);
        if (!looks) {
            return NONE;
        }
        double nearest = seen.stream()
                .mapToDouble(Seen::mm)
                .filter(mm -> !Double.isNaN(mm))
                .min()
                .orElse(Double.NaN);
        if (Double.isNaN(nearest)) {
            return NO_READING;
        }
        return Double.isInfinite(nearest)
                ? Value.CLEAR
                : Value.of(Math.max(0, Math.round(nearest - radiusMm)), Unit.MM);
    }

    private boolean addRangeFinders(HullGap side, List<Seen> seen) {
        boolean looks = false;
        for (Received<RangeReading> received : reports.ranges().values()) {
            RangeReading reading = received.value();
            if (reading.isHorizontal() && side.isSeenIn(reading.directionDeg())) {
                looks = true;
                boolean old = time.secondsSince(received.atNanos()) > OLD_S;
                double mm = reading.mm() >= reading.mostMm() ? Double.POSITIVE_INFINITY : reading.mm();
                seen.add(new Seen(reading.directionDeg(), old ? Double.NaN : mm));
            }
        }
        return looks;
    }

    private boolean addRing(HullGap side, List<Seen> seen) {
        Received<ObstacleRing> received = reports.newest(ObstacleRing.class).orElse(null);
        if (received == null || !received.value().isUsable()) {
            return false;
        }
        ObstacleRing ring = received.value();
        boolean old = time.secondsSince(received.atNanos()) > OLD_S;
        boolean looks = false;
        for (int index = 0; index < ObstacleRing.COUNT; index++) {
            double direction = ring.firstDeg() + index * ring.stepDeg();
            if (side.isSeenIn(direction)) {
                looks = true;
                seen.add(new Seen(direction, old ? Double.NaN : ring.mm(index)));
            }
        }
        return looks;
    }
}
