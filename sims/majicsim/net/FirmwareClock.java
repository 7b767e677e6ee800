package majicsim.net;

/**
 * Advances one firmware with the lab's time. As long as the firmware rests, its steps are left out and made up for together,
 * at the latest before anything else uses the firmware. Guarded by the lab's lock.
 */
public final class FirmwareClock {
    private static final long LONGEST_REST_NANOS = 100_000_000;

    private final Firmware firmware;
    private long nowNanos;
    private long reachedNanos;
    private long dueNanos;

    /**
     * A clock at time 0.
     *
     * @param firmware to advance; nothing else may step it
     */
    public FirmwareClock(Firmware firmware) {
        this.firmware = firmware;
    }

    /**
     * Takes a step of the lab, unless the firmware rests.
     *
     * @param labNanos lab time at the end of the step
     */
    public void step(long labNanos) {
        if (labNanos >= dueNanos) {
            letRestUntil(nowNanos);
            firmware.step((labNanos - nowNanos) / 1e9);
            reachedNanos = labNanos;
            dueNanos = labNanos + Math.min(LONGEST_REST_NANOS, firmware.restNanos());
        }
        nowNanos = labNanos;
    }

    /** Brings the firmware to the present, and lets it take the next step. To be called before anything else uses it. */
    public void wake() {
        letRestUntil(nowNanos);
        dueNanos = nowNanos;
    }

    private void letRestUntil(long nanos) {
        if (nanos > reachedNanos) {
            firmware.rest(nanos - reachedNanos);
            reachedNanos = nanos;
        }
    }
}
