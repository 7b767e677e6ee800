package majic.pioneer.session;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import majic.driver.LastTimes;
import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.Report;
import majic.pioneer.arcos.ReportKind;
import majic.time.TimeSource;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * Requests the reports that a robot sends only on demand, beside its SIPs. For one session.
 *
 * <p>On a fast line the reports that the robot has are requested once at connecting, as streams. Others are requested
 * while something reads them. A request is repeated until a report comes, because requests are not acknowledged and may
 * be lost. A slow line is nearly filled by SIPs alone (ARCOS sheet 1), so nothing is streamed: one packet a second is
 * requested of each kind that is being read.
 */
public final class Subscriptions {
    /** How often to call {@link #requestDue} at least, seconds. */
    public static final double PERIOD_S = 0.5;

    /** No request is sent to a robot that has sent no SIP for so long, seconds. */
    static final double SPEAKING_S = 0.3;

    private static final double REPEAT_S = 1;

    /** A stream without a report for so long is requested again, seconds. */
    private static final double STALE_S = 2;

    /** A report counts as being read for so long after a reading, seconds. */
    private static final double READ_S = 5;

    /** After so many requests without a report the robot is taken not to have the report. */
    private static final int TRIES = 5;

    /** Once: each call of {@code values()} makes a copy. */
    private static final ReportKind[] KINDS = ReportKind.values();

    private final RobotLine line;
    private final LastTimes<ReportKind> read;
    private final LastTimes<ReportKind> received;
    private final LastTimes<ReportKind> requested;
    private final Map<ReportKind, Integer> unanswered = new ConcurrentHashMap<>();

    Subscriptions(RobotLine line, TimeSource time) {
        this.line = line;
        this.read = new LastTimes<>(time);
        this.received = new LastTimes<>(time);
        this.requested = new LastTimes<>(time);
    }

    /** Requests the reports that the robot has, on a fast line; to be called once, after CONFIG. */
    void begin(@Nullable Config config) {
        for (ReportKind kind : KINDS) {
            if (line.isFast() && line.delivers(kind) && kind.isRequestedAtStart(config)) {
                request(kind);
            }
        }
    }

    /**
     * Notes that a report is being read, unless the thread only observes; to be called with each reading. Sends
     * nothing.
     */
    public void read(ReportKind kind) {
        if (!WaitPolicy.isObserving()) {
            read.record(kind);
        }
    }

    /** Notes that a report came. */
    void received(Report report) {
        ReportKind kind = ReportKind.of(report);
        received.record(kind);
        unanswered.remove(kind);
    }

    /** Whether the last report of a kind is less than 2 s old. */
    public boolean isFresh(ReportKind kind) {
        return received.secondsSince(kind) < STALE_S;
    }

    /**
     * Whether the line does not deliver the report, or the robot left so many requests unanswered that it counts as
     * missing.
     */
    public boolean isMissing(ReportKind kind) {
        return !line.delivers(kind) || unanswered.getOrDefault(kind, 0) >= TRIES;
    }

    /**
     * Sends the requests that are due; to be called every {@link #PERIOD_S} or more often, by one thread, while the
     * robot reports.
     */
    void requestDue() {
        for (ReportKind kind : KINDS) {
            if (isRead(kind) && isDue(kind) && !isMissing(kind)) {
                request(kind);
            }
        }
    }

    private boolean isRead(ReportKind kind) {
        return read.secondsSince(kind) < READ_S;
    }

    private boolean isDue(ReportKind kind) {
        boolean waiting = requested.secondsSince(kind) < REPEAT_S;
        boolean flowing = line.isFast() && isFresh(kind);
        return !waiting && !flowing;
    }

    private void request(ReportKind kind) {
        requested.record(kind);
        unanswered.merge(kind, 1, Integer::sum);
        line.send(line.isFast() ? kind.stream() : kind.once());
    }
}
