package majicsim.net;

import java.util.concurrent.locks.ReentrantLock;

/**
 * What a port is connected to.
 *
 * @param lock the lab's one lock; held around every call of the firmware
 * @param firmware of the robot behind the port
 * @param faults ordered for this robot's lines
 */
public record Wiring(ReentrantLock lock, Firmware firmware, Faults faults) {
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
