package majic.driver;

import majic.bot.Pose;

/**
 * Estimates the pose of a robot without odometry from the motions that it was commanded to make, one after the other.
 * All times are on one clock, the robot's or the computer's, in one unit. Thread-safe.
 */
public final class DeadReckoning {
    private Pose start = Pose.START;
    private Segment segment = Segment.STATIONARY;

    /** The part of the path between two commands. */
    @FunctionalInterface
    public interface Segment {
        /** The robot does not move. */
        Segment STATIONARY = (start, time) -> start;

        /**
         * The pose during this part of the path.
         *
         * @param start the pose at its beginning
         * @param time a time; before the beginning the pose is the start, and after the end of a limited motion the end
         */
        Pose at(Pose start, long time);
    }

    /**
     * Begins the next part of the path where the last one is at that time.
     *
     * @param next begins now
     * @param time {@link Long#MAX_VALUE} if the last one has ended by itself
     */
    public synchronized void begin(Segment next, long time) {
        start = at(time);
        segment = next;
    }

    /** Starts again at {@link Pose#START}, stationary. */
    public synchronized void reset() {
        start = Pose.START;
        segment = Segment.STATIONARY;
    }

    /** The estimated pose at a time that is not before the beginning of the last part. */
    public synchronized Pose at(long time) {
        return segment.at(start, time);
    }
}
