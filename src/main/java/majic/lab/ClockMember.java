package majic.lab;

/** Holds the state of one member of a {@link LabClock}, and since when it has it. Guarded by the clock's lock. */
final class ClockMember {
    private boolean waiting;
    private long sinceNanos = System.nanoTime();

    void runs() {
        becomes(false);
    }

    void waits() {
        becomes(true);
    }

    boolean hasRunLessThan(long nanos) {
        return !waiting && System.nanoTime() - sinceNanos < nanos;
    }

    private void becomes(boolean nowWaiting) {
        waiting = nowWaiting;
        sinceNanos = System.nanoTime();
    }

    /** Describes the state, for instance {@code running for 10.2 s} of real time. */
    @Override
    public String toString() {
        double seconds = (System.nanoTime() - sinceNanos) / 1e9;
        return (waiting ? "waiting for " : "running for ") + Math.round(seconds * 10) / 10.0 + " s";
    }
}
