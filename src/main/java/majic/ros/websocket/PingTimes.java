package majic.ros.websocket;

import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.Deque;

/**
 * Measures by pings how long a message takes to the server and back. What the server sends waits in the same queue as
 * its pongs, so a slow connection shows as well. Has no clock. Thread-safe.
 */
final class PingTimes {
    /** More pings without an answer are not kept: the server leaves pings unanswered, or has ended. */
    private static final int MOST_UNANSWERED = 64;

    private final Deque<Long> unanswered = new ArrayDeque<>();
    private double measuredS;
    private boolean answers;

    /** Returns the content of a ping that is sent now. */
    synchronized byte[] ping(long nowNanos) {
        unanswered.add(nowNanos);
        if (unanswered.size() > MOST_UNANSWERED) {
            unanswered.remove();
        }
        return ByteBuffer.allocate(Long.BYTES).putLong(nowNanos).array();
    }

    /** Takes a pong. It answers all earlier pings as well; one that was not asked for counts for nothing. */
    synchronized void pong(byte[] content, long nowNanos) {
        long sentNanos = content.length == Long.BYTES ? ByteBuffer.wrap(content).getLong() : 0;
        if (unanswered.contains(sentNanos)) {
            unanswered.removeIf(earlier -> earlier - sentNanos <= 0);
            measuredS = (nowNanos - sentNanos) / 1e9;
            answers = true;
        }
    }

    /** Returns the newest round trip, or how long an answer has been due if that is longer; 0 without any answer, s. */
    synchronized double seconds(long nowNanos) {
        Long oldest = unanswered.peek();
        double waitingS = oldest == null || !answers ? 0 : (nowNanos - oldest) / 1e9;
        return Math.max(measuredS, waitingS);
    }
}
