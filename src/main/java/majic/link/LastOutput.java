package majic.link;

import com.fazecast.jSerialComm.SerialPort;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/**
 * Keeps serial ports usable while the program ends. jSerialComm gives its library up as soon as the end begins, and what
 * a robot is told last, to stand, would not go out any more; so it is made to wait until the ports were closed.
 */
final class LastOutput {
    /** Who closes a port later than this after the end began is not waited for. */
    private static final long LONGEST_NANOS = TimeUnit.MILLISECONDS.toNanos(1500);

    private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(5);
    private static final Set<Link> OPEN = ConcurrentHashMap.newKeySet();

    static {
        SerialPort.addShutdownHook(new Thread(LastOutput::await, "last output of serial ports"));
    }

    private LastOutput() {}

    static void opened(Link link) {
        OPEN.add(link);
    }

    static void closed(Link link) {
        OPEN.remove(link);
    }

    private static void await() {
        long deadlineNanos = System.nanoTime() + LONGEST_NANOS;
        while (!OPEN.isEmpty() && System.nanoTime() < deadlineNanos) {
            LockSupport.parkNanos(LOOK_NANOS);
        }
    }
}
