package majic.link;

import com.fazecast.jSerialComm.SerialPort;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/**
 * Keeps serial ports usable while the program ends. jSerialComm shuts its library down at the beginning of the
 * program's end, before the final stop of the robots is sent; a hook delays that until the ports are closed.
 */
final class SerialShutdownDelay {
    /** The longest delay. */
    private static final long LONGEST_NANOS = TimeUnit.MILLISECONDS.toNanos(1500);

    private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(5);
    private static final Set<Link> OPEN = ConcurrentHashMap.newKeySet();

    static {
        SerialPort.addShutdownHook(new Thread(SerialShutdownDelay::await, "last output of serial ports"));
    }

    private SerialShutdownDelay() {}

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
