package majic.pioneer.aria;

import com.mobilerobots.Aria.ArRobot;
import com.mobilerobots.Aria.ArTime;

/**
 * Detects that ARIA has received another SIP, by the time since the last one. An ARIA that does not tell this time
 * counts the SIPs of the last second; then each of its cycles counts as a SIP while there are any. For one thread.
 */
final class SipDetector {
    /** SIPs are farther apart, and their times are less exact, nanoseconds. */
    private static final long APART_NANOS = 15_000_000;

    private final ArRobot robot;
    private boolean withoutTimes;
    private boolean seen;
    private long lastNanos;
    private long lastCycle;

    SipDetector(ArRobot robot) {
        this.robot = robot;
    }

    /** Whether a SIP has come since the last call; with ARIA's lock held. */
    boolean isNew(long nowNanos) {
        if (!withoutTimes) {
            try {
                return isNewByTime(nowNanos);
            } catch (LinkageError e) {
                withoutTimes = true;
            }
        }
        long cycle = robot.getCounter();
        boolean fresh = cycle != lastCycle && robot.getMotorPacCount() > 0;
        lastCycle = cycle;
        return fresh;
    }

    /** The first time is not counted: before the first SIP it is the one at which ARIA began to connect. */
    private boolean isNewByTime(long nowNanos) {
        ArTime received = robot.getLastOdometryTime();
        long atNanos = nowNanos - received.mSecSince() * 1_000_000L;
        received.delete();
        boolean changed = !seen || Math.abs(atNanos - lastNanos) > APART_NANOS;
        boolean fresh = seen && changed;
        seen = true;
        lastNanos = changed ? atNanos : lastNanos;
        return fresh;
    }
}
