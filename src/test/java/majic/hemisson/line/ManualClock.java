package majic.hemisson.line;

import majic.time.Signal;
import majic.time.TimeSource;

/** A clock that a test moves by hand; no thread waits on it. */
final class ManualClock implements TimeSource {
    private long nanos = 1_000_000_000;

    void pass(double seconds) {
        nanos += Math.round(seconds * 1e9);
    }

    @Override
    public long nanos() {
        return nanos;
    }

    @Override
    public Signal signal() {
        return TimeSource.system().signal();
    }

    @Override
    public Thread thread(String name, Runnable body) {
        return TimeSource.system().thread(name, body);
    }

    @Override
    public Membership join() {
        return TimeSource.system().join();
    }
}
