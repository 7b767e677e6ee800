package majic.pioneer.session;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.Report;
import majic.pioneer.state.Feed;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * Asks the robot for what it sends beside its SIPs. For one session.
 *
 * <p>On a fast line what the robot has is asked for once at connecting, as a stream. Beyond that the one who reads a feed
 * says so, and as long as nothing comes of it the request is repeated, for requests are not acknowledged and may be lost.
 * On a slow line, which SIPs alone nearly fill (ARCOS sheet 1), nothing is streamed: while somebody reads a feed, one packet
 * of it is asked for each second.
 */
public final class Subscriptions {
    /** How often to look, seconds. */
    public static final double PERIOD_S = 0.5;

    /** A robot that has sent no SIP for so long is left in peace, seconds. */
    static final double SPEAKING_S = 0.3;

    private static final double REPEAT_S = 1;

    /** A stream that was silent for so long has to be asked for again, seconds. */
    private static final double STALE_S = 2;

    /** For how long somebody who has read a feed is taken to be interested in it, seconds. */
    private static final double INTEREST_S = 5;

    /** So many requests without an answer, and the robot has no such thing. */
    private static final int TRIES = 5;

    private final ArcosLine line;
    private final TimeSource time;
    private final Map<Feed, Long> wantedNanos = new ConcurrentHashMap<>();
    private final Map<Feed, Long> heardNanos = new ConcurrentHashMap<>();
    private final Map<Feed, Long> askedNanos = new ConcurrentHashMap<>();
    private final Map<Feed, Integer> unanswered = new ConcurrentHashMap<>();

    Subscriptions(ArcosLine line, TimeSource time) {
        this.line = line;
        this.time = time;
    }

    /** Asks for what the robot has, on a line that has room for it; once, after CONFIG. */
    void begin(@Nullable Config config) {
        for (Feed feed : Feed.values()) {
            if (line.isFast() && feed.isAskedFromTheStart(config)) {
                ask(feed);
            }
        }
    }

    /** Somebody reads this feed; costs nothing and may be said with every reading. */
    public void want(Feed feed) {
        wantedNanos.put(feed, time.nanos());
    }

    /** Takes note of what came. */
    void heard(Report report) {
        for (Feed feed : Feed.values()) {
            if (feed.brings(report)) {
                heardNanos.put(feed, time.nanos());
                unanswered.remove(feed);
            }
        }
    }

    /** Whether what was heard last is of now. */
    public boolean isFresh(Feed feed) {
        return secondsSince(heardNanos.get(feed)) < STALE_S;
    }

    /** Whether the robot has been asked often enough to know that it never sends this. */
    public boolean isMute(Feed feed) {
        return unanswered.getOrDefault(feed, 0) >= TRIES;
    }

    /** Asks for what is due; to be called every {@link #PERIOD_S} while the robot speaks, by one thread. */
    void request() {
        for (Feed feed : Feed.values()) {
            if (isWanted(feed) && isLacking(feed) && !isMute(feed)) {
                ask(feed);
            }
        }
    }

    private boolean isWanted(Feed feed) {
        return secondsSince(wantedNanos.get(feed)) < INTEREST_S;
    }

    private boolean isLacking(Feed feed) {
        boolean asked = secondsSince(askedNanos.get(feed)) < REPEAT_S;
        boolean flowing = line.isFast() && isFresh(feed);
        return !asked && !flowing;
    }

    private double secondsSince(@Nullable Long nanos) {
        return nanos == null ? Double.POSITIVE_INFINITY : time.secondsSince(nanos);
    }

    private void ask(Feed feed) {
        askedNanos.put(feed, time.nanos());
        unanswered.merge(feed, 1, Integer::sum);
        line.send(line.isFast() ? feed.stream() : feed.once());
    }
}
