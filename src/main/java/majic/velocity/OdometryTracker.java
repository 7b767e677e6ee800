package majic.velocity;

import java.util.ArrayDeque;
import java.util.Deque;
import majic.bot.Pose;
import org.jspecify.annotations.Nullable;

/**
 * Makes continuous states of the readings of an odometry, which begins anywhere, may jump, and is set to zero when the
 * base is reset. Time is that of the arrival: the stamps of a robot may jump. Has no clock. Not thread-safe.
 */
final class OdometryTracker {
    /** What a base may have covered beyond its highest velocity without counting as a jump. */
    private static final double JUMP_MM = 50;

    private static final double JUMP_DEG = 10;

    /**
     * Readings that were held up by the network arrive closer together than they were made, by this time at most,
     * seconds.
     */
    private static final double LATE_S = 0.3;

    /**
     * What a base may have covered beyond its highest velocity to a reading of exactly zero without counting as a
     * reset.
     */
    private static final double RESET_MM = 10;

    private static final double RESET_DEG = 2;

    private final BaseDynamics limits;
    private final LastOdometry last;
    private final Deque<TrackedState> window = new ArrayDeque<>();
    private Pose origin = Pose.START;
    private @Nullable Pose lastRaw;
    private double turnedDeg;
    private int jumps;
    private boolean reportsVelocities;

    /** When the last reading arrived that showed a motion, seconds; minus infinity before the first one. */
    private double fastS = Double.NEGATIVE_INFINITY;

    /**
     * Begins with the first reading that is added.
     *
     * @param limits the highest velocities
     * @param last the reading before the connection was lost, which the first one continues unless the odometry was
     *     reset meanwhile or is farther away than the base can have moved; it then stands for the same pose
     */
    OdometryTracker(BaseDynamics limits, LastOdometry last) {
        this.limits = limits;
        this.last = last;
    }

    /**
     * Adds a reading.
     *
     * @param raw the pose in the frame of the odometry
     * @param mmPerSec the reported speed
     * @param degPerSec the reported turn rate
     * @param atNanos when it arrived, not before the one added last
     * @return the state after it
     */
    TrackedState add(Pose raw, double mmPerSec, double degPerSec, long atNanos) {
        TrackedState before = window.peekLast();
        Pose rawBefore = lastRaw;
        if (before == null || rawBefore == null) {
            origin = last.pose().originOf(isContinuedBy(raw, atNanos) ? last.raw() : raw);
            turnedDeg = origin.plus(raw).headingDeg();
        } else if (isJump(rawBefore, raw, (atNanos - before.atNanos()) / 1e9)) {
            jumps++;
            origin = before.pose().originOf(raw);
        } else {
            turnedDeg += Pose.normalised(raw.headingDeg() - rawBefore.headingDeg());
        }
        lastRaw = raw;
        forget(atNanos);
        reportsVelocities |= mmPerSec != 0 || degPerSec != 0;
        TrackedState now = state(origin.plus(raw), mmPerSec, degPerSec, atNanos);
        window.add(now);
        return now;
    }

    /** A base that is where its odometry begins has been reset, unless it was near there before. */
    private boolean isContinuedBy(Pose raw, long atNanos) {
        return last.exists()
                && !isJump(last.raw(), raw, (atNanos - last.atNanos()) / 1e9)
                && !(isAtStart(raw) && !isAtStart(last.raw()));
    }

    private static boolean isAtStart(Pose raw) {
        return raw.distanceMm(Pose.START) < RESET_MM && Math.abs(Pose.normalised(raw.headingDeg())) < RESET_DEG;
    }

    private boolean isJump(Pose before, Pose raw, double seconds) {
        double mm = before.distanceMm(raw);
        double deg = Math.abs(Pose.normalised(raw.headingDeg() - before.headingDeg()));
        double mostDeg = limits.fastestDegPerSec() * (seconds + LATE_S) + JUMP_DEG;
        return mm > limits.fastestMmPerSec() * (seconds + LATE_S) + JUMP_MM
                || (deg > mostDeg && mostDeg < 180)
                || (raw.equals(Pose.START)
                        && (mm > limits.fastestMmPerSec() * seconds + RESET_MM
                                || deg > limits.fastestDegPerSec() * seconds + RESET_DEG));
    }

    /** A base that leaves the velocities of its odometry at zero has those that follow from its poses. */
    private TrackedState state(Pose pose, double mmPerSec, double degPerSec, long atNanos) {
        TrackedState old = window.peekFirst();
        double seconds = old == null ? 0 : (atNanos - old.atNanos()) / 1e9;
        double movedMmPerSec = 0;
        double movedDegPerSec = 0;
        boolean continuous = old == null || old.jumps() == jumps;
        if (old != null && seconds > 0 && continuous) {
            movedMmPerSec = travelledMm(old.pose(), pose) / seconds;
            movedDegPerSec = (turnedDeg - old.turnedDeg()) / seconds;
        }
        boolean slow = continuous
                && isBelow(limits.accuracy().stationaryMmPerSec(), mmPerSec, degPerSec)
                && isBelow(limits.accuracy().driftMmPerSec(), movedMmPerSec, movedDegPerSec);
        if (!slow) {
            fastS = atNanos / 1e9;
        }
        boolean stationary = slow && atNanos / 1e9 - fastS >= limits.accuracy().restS();
        return new TrackedState(
                pose,
                turnedDeg,
                reportsVelocities ? mmPerSec : movedMmPerSec,
                reportsVelocities ? degPerSec : movedDegPerSec,
                stationary,
                jumps,
                atNanos);
    }

    /** The distance between two poses, negative for a motion backward. */
    private static double travelledMm(Pose from, Pose to) {
        double distance = from.distanceMm(to);
        return to.aheadMm(from) > 0 ? -distance : distance;
    }

    private boolean isBelow(double mostMmPerSec, double mmPerSec, double degPerSec) {
        return Math.abs(mmPerSec) < mostMmPerSec
                && Math.abs(degPerSec) < limits.accuracy().stationaryDegPerSec();
    }

    /** Keeps the states within the window, and the last one that is older. */
    private void forget(long nowNanos) {
        long oldest = nowNanos - (long) (limits.accuracy().windowS() * 1e9);
        while (window.size() > 1 && second().atNanos() <= oldest) {
            window.remove();
        }
    }

    private TrackedState second() {
        return window.stream().skip(1).findFirst().orElseThrow();
    }
}
