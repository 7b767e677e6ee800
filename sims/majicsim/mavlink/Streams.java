package majicsim.mavlink;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import majicsim.mavlink.message.MessageType;

/** Which messages a ground station gets by itself, and how often (sheet 5). Times are ns since the start. */
final class Streams {
    private static final long SECOND = 1_000_000_000L;
    private static final int ALL = 0;

    /** The groups of REQUEST_DATA_STREAM; their messages come once a second without being asked for. */
    private static final Map<Integer, List<MessageType>> GROUPS = Map.of(
            2,
            List.of(
                    MessageType.SYS_STATUS,
                    MessageType.MISSION_CURRENT,
                    MessageType.GPS_RAW_INT,
                    MessageType.POSITION_TARGET_GLOBAL_INT),
            3,
            List.of(MessageType.RC_CHANNELS),
            6,
            List.of(MessageType.GLOBAL_POSITION_INT, MessageType.LOCAL_POSITION_NED),
            10,
            List.of(MessageType.ATTITUDE),
            11,
            List.of(MessageType.VFR_HUD),
            12,
            List.of(
                    MessageType.SYSTEM_TIME,
                    MessageType.BATTERY_STATUS,
                    MessageType.RANGEFINDER,
                    MessageType.DISTANCE_SENSOR,
                    MessageType.OBSTACLE_DISTANCE));

    private final Map<MessageType, Stream> streams = new EnumMap<>(MessageType.class);
    private final List<MessageType> once = new ArrayList<>();
    private long nowNanos;

    private record Stream(long intervalNanos, long dueNanos) {}

    Streams() {
        restart();
    }

    /** Forgets all wishes, as the vehicle does when it starts. */
    void restart() {
        nowNanos = 0;
        streams.clear();
        once.clear();
        streams.put(MessageType.HEARTBEAT, new Stream(SECOND, 0));
        GROUPS.values().forEach(group -> group.forEach(type -> interval(type, 0)));
    }

    /** Sends a message at an interval; 0 is the usual one, a negative one none. */
    void interval(MessageType type, long nanos) {
        if (nanos < 0) {
            streams.remove(type);
        } else if (nanos > 0 || isUsual(type)) {
            long interval = nanos == 0 ? SECOND : nanos;
            streams.put(type, new Stream(interval, nowNanos + interval));
        } else {
            streams.remove(type);
        }
    }

    private static boolean isUsual(MessageType type) {
        return type == MessageType.HEARTBEAT || GROUPS.values().stream().anyMatch(group -> group.contains(type));
    }

    /** Sends a message once. */
    void once(MessageType type) {
        once.add(type);
    }

    /** REQUEST_DATA_STREAM: the messages of a group, so many a second; 0 stops them. */
    void rate(int group, int hertz) {
        GROUPS.forEach((number, types) -> {
            if (group == ALL || group == number) {
                types.forEach(type -> interval(type, hertz == 0 ? -1 : SECOND / hertz));
            }
        });
    }

    /** What is due now, in the order of the messages' numbers. */
    List<MessageType> due(long newNanos) {
        nowNanos = newNanos;
        List<MessageType> due = new ArrayList<>(once);
        once.clear();
        for (Map.Entry<MessageType, Stream> entry : streams.entrySet()) {
            Stream stream = entry.getValue();
            if (stream.dueNanos() <= nowNanos) {
                due.add(entry.getKey());
                long next = Math.max(stream.dueNanos() + stream.intervalNanos(), nowNanos + 1);
                entry.setValue(new Stream(stream.intervalNanos(), next));
            }
        }
        return due;
    }

    /** When something is due next. */
    long dueNanos() {
        if (!once.isEmpty()) {
            return nowNanos;
        }
        long due = Long.MAX_VALUE;
        for (Stream stream : streams.values()) {
            due = Math.min(due, stream.dueNanos());
        }
        return due;
    }
}
