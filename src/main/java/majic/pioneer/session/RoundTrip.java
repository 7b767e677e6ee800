package majic.pioneer.session;

import majic.driver.RobotWait;
import majic.pioneer.arcos.ArcosCommand;
import majic.time.TimeSource;

/**
 * Finds out whether a robot has received everything that was sent to it. ARCOS acknowledges no command, but it obeys
 * commands in their order, and it answers CONFIG at once (ARCOS sheet 10): when that answer comes, all commands before
 * the request have arrived. On a line that delays, the reports that come before the answer may be older than these
 * commands. For one session; thread-safe.
 */
final class RoundTrip {
    private static final double REPEAT_S = 0.2;

    /** A request without an answer for so long was lost, seconds. */
    private static final double LOST_S = 3;

    private final RobotLine line;
    private final RobotWait waiting;
    private long requests;
    private long answers;
    private long requestedNanos;

    /**
     * Creates one before the first request.
     *
     * @param waiting woken after each answer, and when the line ends
     */
    RoundTrip(RobotLine line, RobotWait waiting) {
        this.line = line;
        this.waiting = waiting;
    }

    /**
     * Notes that an answer came; not more than there were requests, of which there are others while a robot is
     * connected.
     */
    synchronized void answered() {
        answers = Math.min(answers + 1, requests);
    }

    /**
     * Waits until the robot has received everything that was sent before. Repeats the request, which may be lost.
     *
     * @param seconds the longest wait
     * @return whether it has; false also if the line ended meanwhile
     */
    boolean await(double seconds) {
        TimeSource time = waiting.time();
        long beganNanos = time.nanos();
        long first = request();
        while (!isAnswered(first) && !line.hasEnded() && time.secondsSince(beganNanos) < seconds) {
            if (!waiting.await(() -> isAnswered(first) || line.hasEnded(), REPEAT_S)) {
                request();
            }
        }
        return isAnswered(first);
    }

    /** Sends a request and returns its number; answers come in the order of the requests. */
    private long request() {
        long number;
        synchronized (this) {
            if (answers < requests && waiting.time().secondsSince(requestedNanos) > LOST_S) {
                answers = requests;
            }
            requestedNanos = waiting.time().nanos();
            number = ++requests;
        }
        line.sendIfPossible(ArcosCommand.CONFIG.packet(1));
        return number;
    }

    private synchronized boolean isAnswered(long request) {
        return answers >= request;
    }
}
