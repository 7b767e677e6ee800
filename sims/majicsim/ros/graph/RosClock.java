package majicsim.ros.graph;

/** The robot's clock: lab time since a fixed date, so that labs repeat exactly. Guarded by the lab's lock. */
public final class RosClock {
    /** The time of the captured session, when the lab opens; ns since 1970. */
    public static final long START_NANOS = 1_795_314_349_000_000_000L;

    private long labNanos;
    private long jumpedNanos;

    /**
     * Lets time pass.
     *
     * @param nanos lab time
     */
    public void advance(long nanos) {
        labNanos += nanos;
    }

    /**
     * Sets the clock forward or back, as a time server does. Timers of the network, which use {@link #elapsedNanos()},
     * do not notice.
     *
     * @param nanos by how much; negative is back
     */
    public void jump(long nanos) {
        jumpedNanos += nanos;
    }

    /**
     * The time of day.
     *
     * @return ns since 1970
     */
    public long nanos() {
        return START_NANOS + labNanos + jumpedNanos;
    }

    /**
     * The time since the robot was switched on.
     *
     * @return ns of lab time; jumps do not count
     */
    public long elapsedNanos() {
        return labNanos;
    }
}
