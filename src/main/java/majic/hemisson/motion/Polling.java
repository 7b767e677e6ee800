package majic.hemisson.motion;

import majic.hemisson.line.Conversation;
import majic.hemisson.line.Exchange;
import majic.hemisson.line.Identity;
import majic.hemisson.readings.PollSchedule;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * Sends the polls: one at a time, more often while the robot may move, and none shortly before the end of a timed
 * motion, so that the line is free for its stop. Used by the timer thread.
 */
final class Polling {
    private static final int IDLE_TICKS_PER_POLL = 2;

    private final PollSchedule schedule;
    private final MotionWatch motion;
    private final TimeSource time;
    private volatile @Nullable Exchange last;
    private long ticks;

    Polling(PollSchedule schedule, MotionWatch motion, TimeSource time) {
        this.schedule = schedule;
        this.motion = motion;
        this.time = time;
    }

    /** Starts with a new connection. */
    void begin() {
        last = null;
    }

    /** Sends the next poll if it is due. */
    void tick(Conversation conversation, Identity identity) {
        ticks++;
        Exchange before = last;
        boolean moving = conversation.mayMove();
        boolean due = moving || ticks % IDLE_TICKS_PER_POLL == 0;
        boolean stopIsNear = moving && motion.isEndNear(time.nanos(), conversation.quality());
        if (due && (before == null || before.isDone()) && !stopIsNear) {
            last = conversation.ask(schedule.next(time.nanos(), moving, identity));
        }
    }
}
