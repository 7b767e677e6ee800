package majic.mavlink.session;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.stream.Stream;
import majic.bot.Value;
import majic.mavlink.frame.MavlinkMessageType;
import majic.mavlink.frame.OutgoingMessage;
import majic.mavlink.message.CommandAck;
import majic.mavlink.message.MavlinkRequests;
import majic.time.TimeSource;

/**
 * Asks a vehicle for the reports that MAJIC needs, again when they do not come as often as asked for: after a restart
 * of the autopilot, the loss of a request, or a change by another ground station (MAVLink sheet 5). A radio that does
 * not carry more is asked more and more rarely. Further requests are sent one by one, so that a stop never waits behind
 * several of them.
 */
final class DataRates {
    private static final int POSE_HZ = 10;
    private static final int LANDED_HZ = 5;
    private static final double CHECK_S = 2;

    /** Fewer reports are asked for again: half of those that were asked for. */
    private static final double LEAST_HZ = POSE_HZ / 2.0;

    /** After so many rounds of requests that did not help, the next ones have more time between them. */
    private static final int MOST_VAIN_ROUNDS = 3;

    private static final double LONGEST_PERIOD_S = 60;

    /** Single reports that do not come are asked for again as often: an autopilot may not have them. */
    private static final int MOST_SINGLE_ROUNDS = 5;

    /** Requests have helped if the reports come more often by this factor. */
    private static final double HELPFUL = 1.25;

    /**
     * The groups of an autopilot without single messages, and how often: status, positions, attitude, speed, ranges.
     */
    private static final Map<Integer, Integer> STREAMS = Map.of(2, 2, 6, POSE_HZ, 10, POSE_HZ, 11, 2, 12, POSE_HZ);

    private static final List<MavlinkMessageType> POSE =
            List.of(MavlinkMessageType.ATTITUDE, MavlinkMessageType.LOCAL_POSITION_NED);

    /** What a copter does not fly without, besides. */
    private static final List<MavlinkMessageType> FLIGHT =
            List.of(MavlinkMessageType.GLOBAL_POSITION_INT, MavlinkMessageType.EXTENDED_SYS_STATE);

    private final VehicleSession session;
    private final VehicleReports reports;
    private final TimeSource time;
    private final Map<MavlinkMessageType, Integer> wanted = new EnumMap<>(MavlinkMessageType.class);
    private final Map<MavlinkMessageType, Long> before = new ConcurrentHashMap<>();
    private final Queue<OutgoingMessage> waiting = new ArrayDeque<>();
    private final Consumer<String> notices;
    private long requestedNanos;
    private long checkedNanos;
    private int rounds;
    private double bestHz;
    private int vainRounds;
    private int singleRounds;
    private double periodS = CHECK_S;
    private boolean told;
    private volatile boolean restarted;

    /**
     * Asks for nothing yet.
     *
     * @param notices receives messages for the user
     */
    DataRates(VehicleSession session, VehicleReports reports, TimeSource time, Consumer<String> notices) {
        this.session = session;
        this.reports = reports;
        this.time = time;
        this.notices = notices;
        wanted.put(MavlinkMessageType.ATTITUDE, POSE_HZ);
        wanted.put(MavlinkMessageType.LOCAL_POSITION_NED, POSE_HZ);
        wanted.put(MavlinkMessageType.GLOBAL_POSITION_INT, 2);
        wanted.put(MavlinkMessageType.GPS_RAW_INT, 1);
        wanted.put(MavlinkMessageType.SYS_STATUS, 1);
        wanted.put(MavlinkMessageType.BATTERY_STATUS, 1);
        wanted.put(MavlinkMessageType.DISTANCE_SENSOR, POSE_HZ);
        wanted.put(MavlinkMessageType.OBSTACLE_DISTANCE, POSE_HZ);
    }

    /** Sends the requests, all at once: the vehicle does not move by MAJIC yet. */
    synchronized void request() {
        waiting.clear();
        requests().forEach(session::send);
        singleRounds = 0;
        begin();
    }

    private List<OutgoingMessage> requests() {
        requestedNanos = time.nanos();
        if (session.vehicle() == VehicleClass.COPTER) {
            wanted.put(MavlinkMessageType.GLOBAL_POSITION_INT, POSE_HZ);
            wanted.put(MavlinkMessageType.EXTENDED_SYS_STATE, LANDED_HZ);
        }
        List<OutgoingMessage> requests = new ArrayList<>();
        if (isOld()) {
            STREAMS.forEach((stream, hz) -> requests.add(MavlinkRequests.stream(session.system(), stream, hz)));
        } else {
            wanted.forEach((type, hz) -> requests.add(MavlinkRequests.interval(session.system(), type, hz)));
        }
        rounds++;
        return requests;
    }

    private void begin() {
        checkedNanos = time.nanos();
        Stream.concat(POSE.stream(), FLIGHT.stream()).forEach(type -> before.put(type, reports.count(type)));
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

    /** Sends the requests again if they are not fulfilled, one message at each call; called often. */
    synchronized void check() {
        if (restarted) {
            restarted = false;
            hurry();
            request();
            return;
        }
        OutgoingMessage next = waiting.poll();
        if (next != null) {
            session.send(next);
            begin();
            return;
        }
        if (requestedNanos == 0 || time.secondsSince(checkedNanos) < CHECK_S) {
            return;
        }
        double hz = slowestHz();
        if (hz >= LEAST_HZ) {
            askForSingleOnes();
        }
        begin();
        if (hz >= LEAST_HZ) {
            rounds = 0;
            hurry();
        } else {
            askAgain(hz);
        }
    }

    /** Asks as often as at the beginning. */
    private void hurry() {
        bestHz = 0;
        vainRounds = 0;
        periodS = CHECK_S;
    }

    private double slowestHz() {
        return POSE.stream().mapToDouble(this::hz).min().orElse(0);
    }

    private double hz(MavlinkMessageType type) {
        return (reports.count(type) - before.getOrDefault(type, 0L)) / time.secondsSince(checkedNanos);
    }

    /** Asks a copter again for what it does not fly without, where only that request was lost. */
    private void askForSingleOnes() {
        List<MavlinkMessageType> lost = session.vehicle() == VehicleClass.COPTER
                ? FLIGHT.stream()
                        .filter(type -> hz(type) < wanted.getOrDefault(type, 0) / 2.0)
                        .toList()
                : List.of();
        if (lost.isEmpty()) {
            singleRounds = 0;
        } else if (singleRounds < MOST_SINGLE_ROUNDS && !isOld()) {
            singleRounds++;
            lost.forEach(type ->
                    waiting.add(MavlinkRequests.interval(session.system(), type, wanted.getOrDefault(type, 1))));
        }
    }

    private void askAgain(double hz) {
        if (hz > HELPFUL * bestHz + 1 / CHECK_S) {
            hurry();
            bestHz = hz;
        }
        if (time.secondsSince(requestedNanos) < periodS) {
            return;
        }
        vainRounds++;
        if (vainRounds > MOST_VAIN_ROUNDS) {
            periodS = Math.min(LONGEST_PERIOD_S, 2 * periodS);
            tell(hz);
        }
        waiting.addAll(requests());
    }

    /** A vehicle that sends no position at all has none yet. */
    private void tell(double hz) {
        boolean matters =
                session.vehicle().isMoved() && session.modes().guided().isPresent();
        if (hz > 0 && matters && !told) {
            told = true;
            notices.accept("its position and attitude come only " + Value.plain(Math.round(10 * hz) / 10.0)
                    + " times a second, and MAJIC asks for " + POSE_HZ
                    + ": the connection may be a slow radio; motions are less exact, and may fail");
        }
    }
}
