package majic.shared.desk;

import java.util.Locale;
import majic.bot.BotException;
import majic.time.TimeSource;

/**
 * Keeps a session whose hold was ended by a stop or a fault from claiming the robot again by what it had sent before it
 * could know of that: for a second, and, while it goes on sending speeds, until it pauses. Thread-safe.
 */
final class ReclaimPause {
    /** As long as a request is valid, seconds. */
    private static final double PAUSE_S = 1;

    private final TimeSource time;
    private String session = "";
    private long untilNanos;

    ReclaimPause(TimeSource time) {
        this.time = time;
    }

    /** The hold of a session was ended by something other than itself. */
    synchronized void begin(String ofSession) {
        session = ofSession;
        untilNanos = time.nanos() + (long) (PAUSE_S * 1e9);
    }

    /**
     * Refuses a motion that would claim the robot.
     *
     * @param continuous whether it is one of a sequence of speeds; the pause lasts until the sequence has ended
     * @throws BotException while the pause lasts
     */
    synchronized void check(String bySession, boolean continuous) {
        double leftS = (untilNanos - time.nanos()) / 1e9;
        if (leftS <= 0 || !session.equals(bySession)) {
            return;
        }
        if (continuous) {
            begin(bySession);
        }
        throw new BotException(String.format(
                Locale.ROOT, "the robot was stopped; it can be claimed again in %.1f s", Math.max(leftS, 0.1)));
    }
}
