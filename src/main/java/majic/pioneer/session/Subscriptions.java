package majic.pioneer.session;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import majic.driver.LastTimes;
import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.Report;
import majic.pioneer.state.Feed;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * Requests the reports that a robot sends only on demand, beside its SIPs. For one session.
 *
 * <p>On a fast line the feeds that the robot has are requested once at connecting, as streams. Other feeds are requested
 * while something reads them. A request is repeated until a report comes, because requests are not acknowledged and may be
 * lost. A slow line is nearly filled by SIPs alone (ARCOS sheet 1), so nothing is streamed: one packet a second is
 * requested of each feed that is being read.
 */
public final class Subscriptions {
    /** How often to call {@link #requestDue}, seconds. */
    public static final double PERIOD_S = 0.5;

    /** No request is sent to a robot that has sent no SIP for so long, seconds. */
    static final double SPEAKING_S = 0.3;

    private static final double REPEAT_S = 1;

    /** A stream without a report for so long is requested again, seconds. */
    private static final double STALE_S = 2;

    /** A feed counts as being read for so long after a reading, seconds. */
    private static final double READ_S = 5;

    /** After so many requests without a report the robot is taken not to have the feed. */
    private static final int TRIES = 5;

    private final RobotLine line;
    private final LastTimes<Feed> read;
    private final LastTimes<Feed> received;
    private final LastTimes<Feed> requested;
    private final Map<Feed, Integer> unanswered = new ConcurrentHashMap<>();

    Subscriptions(RobotLine line, TimeSource time) {
        this.line = line;
        this.read = new LastTimes<>(time);
        this.received = new LastTimes<>(time);
        this.requested = new LastTimes<>(time);
    }

    /** Requests the feeds that the robot has, on a fast line; to be called once, after CONFIG. */
    void begin(@Nullable Config config) {
        for (Feed feed : Feed.values()) {
            if (line.isFast() && line.delivers(feed) && feed.isRequestedAtStart(config)) {
                request(feed);
            }
        }
    }

    /** Notes that a feed is being read; to be called with each reading. Sends nothing. */
    public void read(Feed feed) {
        read.record(feed);
    }

    /** Notes that a report came. */
    void received(Report report) {
        for (Feed feed : Feed.values()) {
            if (feed.brings(report)) {
                received.record(feed);
                unanswered.remove(feed);
            }
        }
    }

    /** Whether the last report of a feed is less than 2 s old. */
    public boolean isFresh(Feed feed) {
        return received.secondsSince(feed) < STALE_S;
    }

    /** Whether the line does not deliver the feed, or the robot has left so many requests unanswered that it is taken not to have it. */
    public boolean isMissing(Feed feed) {
        return !line.delivers(feed) || unanswered.getOrDefault(feed, 0) >= TRIES;
    }

    /** Sends the requests that are due; to be called every {@link #PERIOD_S} by one thread, while the robot reports. */
    void requestDue() {
        for (Feed feed : Feed.values()) {
            if (isRead(feed) && isDue(feed) && !isMissing(feed)) {
                request(feed);
            }
        }
    }

    private boolean isRead(Feed feed) {
        return read.secondsSince(feed) < READ_S;
    }

    private boolean isDue(Feed feed) {
        boolean waiting = requested.secondsSince(feed) < REPEAT_S;
        boolean flowing = line.isFast() && isFresh(feed);
        return !waiting && !flowing;
    }

    private void request(Feed feed) {
        requested.record(feed);
        unanswered.merge(feed, 1, Integer::sum);
        line.send(line.isFast() ? feed.stream() : feed.once());
    }
}
