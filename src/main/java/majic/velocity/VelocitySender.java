package majic.velocity;

import majic.bot.LinkLost;
import majic.time.TimeSource;

/**
 * Publishes velocities, and remembers the one in force. A stop is repeated until {@link #endStop}; a velocity that is
 * not renewed is set to zero. Thread-safe; waits for nothing but the write, and what only asks does not even wait for
 * that: the reader thread asks too.
 */
final class VelocitySender {
    /** From one velocity to the next, seconds: 20 a second. */
    static final double PERIOD_S = 0.05;

    /** A velocity that is not renewed for so long is set to zero, seconds: a guard condition may not return. */
    private static final double RENEWAL_S = 0.5;

    /** So long after the last velocity a base may still be coming to rest, seconds. */
    private static final double REST_S = 1;

    private final VelocityOutput output;
    private final TimeSource time;
    private final Listener listener;
    private volatile double mmPerSec;
    private volatile double degPerSec;
    private volatile long sentNanos;
    private volatile long stopNanos;
    private volatile int stopsSent;
    private volatile boolean stopping;
    private volatile boolean ended;

    /** Receives each velocity before it is sent. Called under the lock of the sender; must not wait. */
    interface Listener {
        /** Takes the first velocity after zero ones. */
        default void begins() {}

        /** Takes each velocity. */
        void sent(double mmPerSec, double degPerSec);
    }

    VelocitySender(VelocityOutput output, TimeSource time, Listener listener) {
        this.output = output;
        this.time = time;
        this.listener = listener;
    }

    /**
     * Publishes a velocity, in place of a stop that is being repeated.
     *
     * @throws LinkLost if the connection has ended
     */
    synchronized void send(double newMmPerSec, double newDegPerSec) {
        stopping = false;
        publish(newMmPerSec, newDegPerSec);
    }

    /**
     * Publishes a zero velocity, and has it repeated by {@link #repeat}.
     *
     * @throws LinkLost if the connection has ended
     */
    synchronized void stop() {
        // Before the velocity: one that is seen as zero must not belong to an older stop.
        stopNanos = time.nanos();
        stopsSent = 1;
        stopping = true;
        publish(0, 0);
    }

    /**
     * Publishes the zero velocity again while a stop is in force, and one in place of a velocity that was not renewed.
     */
    synchronized void repeat() {
        if (ended) {
            return;
        }
        if (stopping) {
            stopsSent = stopsSent + 1;
            publish(0, 0);
        } else if (isMoving() && time.secondsSince(sentNanos) > RENEWAL_S) {
            stop();
        }
    }

    /** Ends the repetition of the stop: the base is stationary. */
    synchronized void endStop() {
        stopping = false;
    }

    /** Publishes nothing by itself any more: the connection has ended, or is being closed. */
    void end() {
        ended = true;
        stopping = false;
    }

    /** Whether something is left for {@link #repeat} to do, or the base has only just been commanded. */
    boolean isActive() {
        return !ended && (stopping || isMoving() || time.secondsSince(sentNanos) < REST_S);
    }

    /** Whether the velocity in force is not zero. */
    boolean isMoving() {
        return mmPerSec != 0 || degPerSec != 0;
    }

    /** The speed in force, mm/s. */
    double mmPerSec() {
        return mmPerSec;
    }

    /** The turn rate in force, deg/s. */
    double degPerSec() {
        return degPerSec;
    }

    boolean isStopping() {
        return stopping;
    }

    /** How often the present stop has been published. */
    int stopsSent() {
        return stopsSent;
    }

    /** When the last stop was published first. */
    long stopNanos() {
        return stopNanos;
    }

    private void publish(double newMmPerSec, double newDegPerSec) {
        remember(newMmPerSec, newDegPerSec);
        output.publish(newMmPerSec, newDegPerSec);
    }

    private void remember(double newMmPerSec, double newDegPerSec) {
        if (!isMoving() && (newMmPerSec != 0 || newDegPerSec != 0)) {
            listener.begins();
        }
        mmPerSec = newMmPerSec;
        degPerSec = newDegPerSec;
        sentNanos = time.nanos();
        listener.sent(newMmPerSec, newDegPerSec);
    }
}
