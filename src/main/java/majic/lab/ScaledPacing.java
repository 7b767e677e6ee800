package majic.lab;

import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;

/**
 * Follows the wall clock, multiplied by a speed. A lab that is late makes up for 0.2 s at most, and above real time it
 * runs at most 0.1 s of its time ahead of its members and of the bytes in transit: so no time limit of a driver expires
 * only because the computer is busy.
 */
final class ScaledPacing implements Pacing {
    private static final long MOST_BEHIND_NANOS = 200_000_000;
    private static final long MOST_AHEAD_NANOS = 100_000_000;

    /** What takes longer than this of real time does not delay the lab: it computes, waits in another way or hangs. */
    private static final long LONGEST_DELAY_NANOS = 250_000_000;

    /** Steps due within so much lab time are taken together, because each waking takes longer than a step. */
    private static final long TOGETHER_NANOS = 20_000_000;

    private static final long NOT_DELAYED = Long.MIN_VALUE;
    private static final long LOOK_AGAIN_NANOS = TimeUnit.MICROSECONDS.toNanos(200);

    private final double speed;
    private final BooleanSupplier quiet;
    private final RealTime real;
    private final SpeedWatch watch;
    private long originNanos;
    private long followedNanos;
    private long delayedSinceNanos = NOT_DELAYED;

    /**
     * @param speed how many times as fast as real time
     * @param quiet whether no byte is in transit on any connection
     * @param watch is given both times
     * @param real the wall clock
     */
    ScaledPacing(double speed, BooleanSupplier quiet, SpeedWatch watch, RealTime real) {
        this.speed = speed;
        this.quiet = quiet;
        this.watch = watch;
        this.real = real;
        originNanos = real.nanos();
    }

    @Override
    public boolean mayStep(long nowNanos, BooleanSupplier membersWait) {
        long now = real.nanos();
        watch.check(nowNanos, now);
        long ahead = originNanos + (long) (nowNanos / speed) - now;
        if (ahead > 0) {
            real.pause(Math.max(ahead, (long) (TOGETHER_NANOS / speed)));
            return real.nanos() - now >= ahead;
        }
        long mostBehind = (long) (MOST_BEHIND_NANOS / Math.max(1, speed));
        if (-ahead > mostBehind) {
            originNanos += -ahead - mostBehind;
        }
        return speed <= 1 || isFollowed(nowNanos, membersWait);
    }

    private boolean isFollowed(long nowNanos, BooleanSupplier membersWait) {
        if (nowNanos - followedNanos < MOST_AHEAD_NANOS) {
            return true;
        }
        long now = real.nanos();
        if (delayedSinceNanos == NOT_DELAYED) {
            delayedSinceNanos = now;
        }
        if (now - delayedSinceNanos < LONGEST_DELAY_NANOS && !(membersWait.getAsBoolean() && quiet.getAsBoolean())) {
            real.pause(LOOK_AGAIN_NANOS);
            return false;
        }
        followedNanos = nowNanos;
        delayedSinceNanos = NOT_DELAYED;
        return true;
    }

    @Override
    public boolean awaitsMembers() {
        return false;
    }

    /** The wall clock. */
    interface RealTime {
        long nanos();

        void pause(long nanos);
    }
}
