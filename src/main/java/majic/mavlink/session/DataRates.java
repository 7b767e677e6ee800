package majic.mavlink.session;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import majic.mavlink.frame.MavlinkMessageType;
import majic.mavlink.message.CommandAck;
import majic.mavlink.message.MavlinkRequests;
import majic.time.TimeSource;

/**
 * Asks a vehicle for the reports that MAJIC needs, again when they do not come as often as asked for: after a restart
 * of the autopilot, the loss of a request, or a change by another ground station (MAVLink sheet 5).
 */
final class DataRates {
    private static final int POSE_HZ = 10;
    private static final int LANDED_HZ = 5;
    private static final double CHECK_S = 2;

    /** Less than half of the reports have come. */
    private static final long LEAST = (long) (CHECK_S * POSE_HZ / 2);

    /**
     * The groups of an autopilot without single messages, and how often: status, positions, attitude, speed, ranges.
     */
    private static final Map<Integer, Integer> STREAMS = Map.of(2, 2, 6, POSE_HZ, 10, POSE_HZ, 11, 2, 12, POSE_HZ);

    private final VehicleSession session;
    private final VehicleReports reports;
    private final TimeSource time;
    private final Map<MavlinkMessageType, Integer> wanted = new EnumMap<>(MavlinkMessageType.class);
    private final Map<MavlinkMessageType, Long> before = new ConcurrentHashMap<>();
    private volatile long requestedNanos;
    private volatile long checkedNanos;
    private volatile int rounds;
    private volatile boolean restarted;

    DataRates(VehicleSession session, VehicleReports reports, TimeSource time) {
        this.session = session;
        this.reports = reports;
        this.time = time;
        wanted.put(MavlinkMessageType.ATTITUDE, POSE_HZ);
        wanted.put(MavlinkMessageType.LOCAL_POSITION_NED, POSE_HZ);
        wanted.put(MavlinkMessageType.GLOBAL_POSITION_INT, 2);
        wanted.put(MavlinkMessageType.GPS_RAW_INT, 1);
        wanted.put(MavlinkMessageType.SYS_STATUS, 1);
        wanted.put(MavlinkMessageType.BATTERY_STATUS, 1);
        wanted.put(MavlinkMessageType.DISTANCE_SENSOR, POSE_HZ);
        wanted.put(MavlinkMessageType.OBSTACLE_DISTANCE, POSE_HZ);
    }

    /** Sends the requests. */
    void request() {
        requestedNanos = time.nanos();
        begin();
        if (session.vehicle() == VehicleClass.COPTER) {
            wanted.put(MavlinkMessageType.GLOBAL_POSITION_INT, POSE_HZ);
            wanted.put(MavlinkMessageType.EXTENDED_SYS_STATE, LANDED_HZ);
        }
        if (isOld()) {
            STREAMS.forEach((stream, hz) -> session.send(MavlinkRequests.stream(session.system(), stream, hz)));
        } else {
            wanted.forEach((type, hz) -> session.send(MavlinkRequests.interval(session.system(), type, hz)));
        }
        rounds++;
    }

    private void begin() {
        checkedNanos = time.nanos();
        List.of(MavlinkMessageType.ATTITUDE, MavlinkMessageType.LOCAL_POSITION_NED)
                .forEach(type -> before.put(type, reports.count(type)));
    }

    /**
     * Whether the autopilot has no single messages: it refuses them, or neither answers nor sends them. One that
     * answers has perhaps no position yet, and its groups contain much that a radio does not carry ten times a second.
     */
    private boolean isOld() {
        return session.commands()
                .answer(MavlinkRequests.SET_INTERVAL, 0)
                .map(answer -> new CommandAck(answer.command(), 3).equals(answer))
                .orElse(rounds % 3 == 2);
    }

    /**
     * Takes the restart of the autopilot, which has forgotten the requests; on the reader thread, which sends nothing.
     */
    void restarted() {
        restarted = true;
    }

    /** Sends the requests again if they are not fulfilled; called often. */
    void check() {
        if (restarted) {
            restarted = false;
            request();
            return;
        }
        if (requestedNanos == 0 || time.secondsSince(checkedNanos) < CHECK_S) {
            return;
        }
        boolean slow =
                before.entrySet().stream().anyMatch(entry -> reports.count(entry.getKey()) - entry.getValue() < LEAST);
        if (slow) {
            request();
        } else {
            rounds = 0;
            begin();
        }
    }
}
