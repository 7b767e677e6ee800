package majicsim.net;

/**
 * Advances one firmware with the lab's time. As long as the firmware rests, its steps are left out and made up for
 * together, at the latest before anything else uses the firmware. Guarded by the lab's lock.
 */
public final class FirmwareClock {
    private static final long LONGEST_REST_NANOS = 100_000_000;

    private final Firmware firmware;
    private final LabTime time;
    private final DueTime due;
    private long reachedNanos;

    /**
     * A clock at time 0, stepped as a task of the lab.
     *
     * @param firmware to advance; nothing else may step it
     * @param time of the lab
     */
    public FirmwareClock(Firmware firmware, LabTime time) {
        this.firmware = firmware;
        this.time = time;
        this.due = time.add(this::step);
    }

    /** Takes the present step of the lab. */
    private void step() {
        long nowNanos = time.nowNanos();
        time.beginFirmware();
        letRestUntil(time.beforeNanos());
        firmware.step((nowNanos - time.beforeNanos()) / 1e9);
        reachedNanos = nowNanos;
        due.atLatest(nowNanos + Math.min(LONGEST_REST_NANOS, firmware.restNanos()));
    }

    /**
     * Brings the firmware to the present, and lets it take the next step. To be called before anything else uses it.
     */
    public void wake() {
        letRestUntil(time.nowNanos());
        due.atLatest(time.nowNanos());
    }

    private void letRestUntil(long nanos) {
        if (nanos > reachedNanos) {
            firmware.rest(nanos - reachedNanos);
            reachedNanos = nanos;
        }
    }
}
