package majic.shared.desk;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import majic.bot.BotException;
import majic.time.TimeSource;

/**
 * Keeps sessions whose holds were ended by a stop or a fault from claiming the robot again by what they had sent before
 * they could know of that: for a second, and, while one goes on sending speeds, until it pauses. Thread-safe.
 */
final class ReclaimPause {
    /** As long as a request is valid, seconds. */
    private static final double PAUSE_S = 1;

    private final TimeSource time;
    private final Map<String, Long> untilNanos = new HashMap<>();

    ReclaimPause(TimeSource time) {
        this.time = time;
    }

    /** The hold of a session was ended by something other than itself. */
    synchronized void begin(String session) {
        untilNanos.values().removeIf(end -> leftS(end) <= 0);
        untilNanos.put(session, time.nanos() + (long) (PAUSE_S * 1e9));
    }

    private double leftS(long endNanos) {
        return (endNanos - time.nanos()) / 1e9;
    }

    /**
     * Refuses a motion that would claim the robot.
     *
     * @param continuous whether it is one of a sequence of speeds; the pause lasts until the sequence has ended
     * @throws BotException while the pause lasts
     */
    synchronized void check(String session, boolean continuous) {
        Long end = untilNanos.get(session);
        if (end == null || leftS(end) <= 0) {
            return;
        }
        double leftS = leftS(end);
        if (continuous) {
            begin(session);
        }
        throw new BotException(String.format(
                Locale.ROOT, "the robot was stopped; it can be claimed again in %.1f s", Math.max(leftS, 0.1)));
    }
}
