package majicsim.net;

import java.util.concurrent.locks.ReentrantLock;

/**
 * What a port is connected to.
 *
 * @param lock the lab's one lock; held around every call of the firmware
 * @param firmware of the robot behind the port
 * @param faults ordered for this robot's lines
 * @param waking called before each use of the firmware: ends its rest
 */
public record Wiring(ReentrantLock lock, Firmware firmware, Faults faults, Runnable waking) {
    /** Wires a firmware that never rests. */
    public Wiring(ReentrantLock lock, Firmware firmware, Faults faults) {
        this(lock, firmware, faults, () -> {});
    }

    /**
     * The firmware, for use now: it has reached the present and takes the next step. To be called with the lab's lock held.
     *
     * @return the same at every call
     */
    @Override
    public Firmware firmware() {
        waking.run();
        return firmware;
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
