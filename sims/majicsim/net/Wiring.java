package majicsim.net;

import java.util.concurrent.locks.ReentrantLock;

/**
 * What a port is connected to.
 *
 * @param lock the lab's one lock; held around every call of the firmware
 * @param firmware of the robot behind the port
 * @param faults ordered for this robot's lines
 * @param waking called before each use of the firmware: ends its rest
 * @param due when the ports must be stepped; lowered by lines that keep bytes for later
 */
public record Wiring(ReentrantLock lock, Firmware firmware, Faults faults, Runnable waking, DueTime due) {
    /** Wires a firmware that never rests, to ports that are stepped all the time. */
    public Wiring(ReentrantLock lock, Firmware firmware, Faults faults) {
        this(lock, firmware, faults, () -> {}, faults.time().add(() -> {}));
    }

    /**
     * The firmware, for use now: it has reached the present and takes the next step. To be called with the lab's lock
     * held.
     *
     * @return the same at every call
     */
    @Override
    public Firmware firmware() {
        waking.run();
        return firmware;
    }

    /** Reports that the lines have reached this time; they are stepped all the time during an outage. */
    void tick(long labNanos) {
        if (faults.tick(labNanos)) {
            due.atLatest(labNanos);
        }
    }

    /** Runs an action while the lab does not step; everything that may call the firmware must use this. */
    void locked(Runnable work) {
        lock.lock();
        try {
            work.run();
        } finally {
            lock.unlock();
        }
    }
}
