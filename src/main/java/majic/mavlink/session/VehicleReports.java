package majic.mavlink.session;

import java.util.Comparator;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import majic.mavlink.frame.MavlinkFrame;
import majic.mavlink.frame.MavlinkMessageType;
import majic.mavlink.message.AttitudeReport;
import majic.mavlink.message.AutopilotVersion;
import majic.mavlink.message.BatteryReport;
import majic.mavlink.message.GlobalPosition;
import majic.mavlink.message.GpsFix;
import majic.mavlink.message.LandedState;
import majic.mavlink.message.LocalPosition;
import majic.mavlink.message.ObstacleRing;
import majic.mavlink.message.RangeReading;
import majic.mavlink.message.VehicleHeartbeat;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/** The newest messages of one vehicle, each with the time of its arrival. Thread-safe. */
public final class VehicleReports {
    private static final int MOST_RANGE_FINDERS = 16;

    private final TimeSource time;
    private final Map<Class<?>, Received<?>> newest = new ConcurrentHashMap<>();
    private volatile @Nullable Received<AttitudeReport> attitudeBefore;
    private volatile @Nullable Received<BatteryReport> mainBattery;
    private volatile @Nullable Received<BatteryReport> systemBattery;
    private final Map<Integer, Received<RangeReading>> ranges = new ConcurrentHashMap<>();
    private final Map<MavlinkMessageType, Long> counts = new ConcurrentHashMap<>();

    VehicleReports(TimeSource time) {
        this.time = time;
    }

    /** Takes a message of the vehicle; on the reader thread. */
    void take(MavlinkFrame frame) {
        counts.merge(frame.type(), 1L, Long::sum);
        switch (frame.type()) {
            case HEARTBEAT -> put(VehicleHeartbeat.of(frame.payload()));
            case ATTITUDE -> putAttitude(AttitudeReport.of(frame.payload()));
            case LOCAL_POSITION_NED -> put(LocalPosition.of(frame.payload()));
            case GLOBAL_POSITION_INT -> put(GlobalPosition.of(frame.payload()));
            case GPS_RAW_INT -> put(GpsFix.of(frame.payload()));
            case AUTOPILOT_VERSION -> put(AutopilotVersion.of(frame.payload()));
            case EXTENDED_SYS_STATE -> put(LandedState.of(frame.payload()));
            case OBSTACLE_DISTANCE -> put(ObstacleRing.of(frame.payload()));
            case BATTERY_STATUS -> {
                BatteryReport battery = BatteryReport.ofBattery(frame.payload());
                if (battery.id() == 0) {
                    mainBattery = new Received<>(battery, time.nanos());
                }
            }
            case SYS_STATUS -> systemBattery = new Received<>(BatteryReport.ofSystem(frame.payload()), time.nanos());
            case DISTANCE_SENSOR -> put(RangeReading.of(frame.payload()));
            default -> {}
        }
    }

    private void put(Object message) {
        newest.put(message.getClass(), new Received<>(message, time.nanos()));
    }

    private void putAttitude(AttitudeReport attitude) {
        attitudeBefore = newest(AttitudeReport.class).orElse(null);
        put(attitude);
    }

    private void put(RangeReading reading) {
        if (ranges.size() < MOST_RANGE_FINDERS || ranges.containsKey(reading.id())) {
            ranges.put(reading.id(), new Received<>(reading, time.nanos()));
        }
    }

    /** Returns how many messages of a kind have come. */
    long count(MavlinkMessageType type) {
        return counts.getOrDefault(type, 0L);
    }

    /** Returns the newest message of a class; empty before the first. */
    @SuppressWarnings("unchecked")
    public <T> Optional<Received<T>> newest(Class<T> type) {
        return Optional.ofNullable((Received<T>) newest.get(type));
    }

    /**
     * Returns the newest message of a class that is not older than a time.
     *
     * @param seconds the greatest age
     */
    public <T> Optional<T> newest(Class<T> type, double seconds) {
        return notOlder(newest(type).orElse(null), seconds);
    }

    /**
     * Returns what the main battery reports: the battery 0 of BATTERY_STATUS, and what that leaves out of SYS_STATUS.
     *
     * @param seconds the greatest age of either
     * @return empty if neither is that new
     */
    public Optional<BatteryReport> battery(double seconds) {
        Optional<BatteryReport> system = notOlder(systemBattery, seconds);
        return notOlder(mainBattery, seconds)
                .map(main -> system.map(main::or).orElse(main))
                .or(() -> system);
    }

    private <T> Optional<T> notOlder(@Nullable Received<T> received, double seconds) {
        return Optional.ofNullable(received)
                .filter(one -> time.secondsSince(one.atNanos()) <= seconds)
                .map(Received::value);
    }

    /**
     * Returns the attitude that was measured nearest to a moment: one of the last two, since reports may overtake each
     * other.
     *
     * @param bootMs the moment, by the clock of the autopilot
     */
    public Optional<Received<AttitudeReport>> attitudeAt(long bootMs) {
        return Stream.of(newest(AttitudeReport.class), Optional.ofNullable(attitudeBefore))
                .flatMap(Optional::stream)
                .min(Comparator.comparingLong(
                        received -> Math.abs(received.value().bootMs() - bootMs)));
    }

    /** Returns the newest readings of the range finders, by their numbers. */
    public Map<Integer, Received<RangeReading>> ranges() {
        return new TreeMap<>(ranges);
    }
}
