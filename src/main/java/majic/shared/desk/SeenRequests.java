package majic.shared.desk;

import java.util.LinkedHashMap;
import java.util.Map;
import majic.shared.message.Request;
import majic.shared.message.RequestReply;
import majic.shared.message.StopMessage;
import org.jspecify.annotations.Nullable;

/**
 * The newest requests of each session to one robot, so that a request that is delivered twice is executed once, and one
 * that was sent before a stop is not executed after it. Thread-safe.
 */
final class SeenRequests {
    private static final int MOST_SESSIONS = 200;
    private static final int MOST_OF_A_SESSION = 100;

    private final Map<String, Log> sessions = new Newest<>(MOST_SESSIONS);

    /** What is known of one session. */
    private static final class Log {
        final Map<Long, RequestReply> replies = new Newest<>(MOST_OF_A_SESSION);
        long highest;
        long voidUpTo;
    }

    /** Keeps the entries that were used last. */
    private static final class Newest<K, V> extends LinkedHashMap<K, V> {
        private static final long serialVersionUID = 1;
        private final int most;

        Newest(int most) {
            super(16, 0.75f, true);
            this.most = most;
        }

        @Override
        protected boolean removeEldestEntry(Map.Entry<K, V> eldest) {
            return size() > most;
        }
    }

    /**
     * Notes a request.
     *
     * @return null for a new one; otherwise what to answer without executing it
     */
    synchronized @Nullable RequestReply begin(Request request) {
        Log log = log(request.sender().session());
        RequestReply before = log.replies.get(request.number());
        if (before != null) {
            return before;
        }
        if (request.number() <= log.voidUpTo) {
            return RequestReply.of(RequestReply.Outcome.STOPPED, "stopped before it began");
        }
        if (request.number() <= log.highest - MOST_OF_A_SESSION) {
            return RequestReply.of(
                    RequestReply.Outcome.REFUSED,
                    "number " + request.number() + " is too old; the last one was " + log.highest);
        }
        log.highest = Math.max(log.highest, request.number());
        log.replies.put(request.number(), RequestReply.of(RequestReply.Outcome.ACCEPTED, ""));
        return null;
    }

    /** Keeps the newest answer to a request, for its second delivery. */
    synchronized void answered(Request request, RequestReply reply) {
        log(request.sender().session()).replies.put(request.number(), reply);
    }

    /** All requests of the session up to a number are void if they have not begun. */
    synchronized void stopped(StopMessage stop) {
        Log log = log(stop.sender().session());
        log.voidUpTo = Math.max(log.voidUpTo, stop.after());
    }

    /** Whether a stop has voided a request of the session. */
    synchronized boolean isVoid(String session, long number) {
        Log log = sessions.get(session);
        return log != null && number > 0 && number <= log.voidUpTo;
    }

    private Log log(String session) {
        return sessions.computeIfAbsent(session, key -> new Log());
    }
}
