package majic.pioneer.aria;

import com.mobilerobots.Aria.ArDeviceConnection;
import com.mobilerobots.Aria.ArRobot;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Function;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.bot.LinkLost;
import org.jspecify.annotations.Nullable;

/**
 * ARIA's object for a robot, which is used by one connection at a time and again by the next. Everything but connecting
 * and disconnecting is done while its lock is held, and nothing waits meanwhile.
 */
final class AriaRobot {
    /** ARIA's own thread holds the lock for a few ms of its cycle; after this time it is taken to hang. */
    private static final long LOCK_NANOS = TimeUnit.SECONDS.toNanos(1);

    private static final long RETRY_NANOS = TimeUnit.MICROSECONDS.toNanos(200);

    private final ArRobot robot;
    private final AriaLaser laser;
    private final AtomicBoolean inUse = new AtomicBoolean();

    /** Kept after the end too: ARIA has it, while its wrapper does not, until it is given another one. */
    private @Nullable ArDeviceConnection device;

    AriaRobot(ArRobot robot, AriaLaser laser) {
        this.robot = robot;
        this.laser = laser;
    }

    /**
     * Calls ARIA with its lock held.
     *
     * @throws LinkLost if the lock is not free within 1 s; nothing was called
     */
    <T> T locked(Function<ArRobot, T> action) {
        lock();
        try {
            return action.apply(robot);
        } finally {
            robot.unlock();
        }
    }

    private void lock() {
        long started = System.nanoTime();
        while (robot.tryLock() != 0) {
            if (System.nanoTime() - started > LOCK_NANOS) {
                throw new LinkLost("connection lost: ARIA has not reacted for 1 s");
            }
            LockSupport.parkNanos(RETRY_NANOS);
        }
    }

    /** Makes what reads the robot's state for one session. */
    AriaReports reports() {
        return new AriaReports(robot);
    }

    /** Its laser, which is connected and read without the lock. */
    AriaLaser laser() {
        return laser;
    }

    /** Reserves it for one connection; false if another one has not ended yet. */
    boolean reserve() {
        return inUse.compareAndSet(false, true);
    }

    boolean isInUse() {
        return inUse.get();
    }

    /**
     * Connects, and starts ARIA's own thread. Blocks for up to 10 s.
     *
     * @throws BotException if that fails; the message says why
     */
    void connect(AriaDevice opening) {
        AriaDevice.Opened opened = opening.open();
        if (opened.result() != 0) {
            String reason = opened.connection().getOpenMessage(opened.result());
            opened.connection().close();
            throw new BotException("ARIA cannot open " + opening.address() + ": " + reason);
        }
        robot.setDeviceConnection(opened.connection());
        device = opened.connection();
        if (!robot.blockingConnect()) {
            throw new ConnectFailed(
                    Reason.WRONG_DEVICE,
                    "ARIA finds no Pioneer at " + opening.address()
                            + ": the line is open, but nothing answers as a robot that ARIA knows; see its messages in the terminal");
        }
        robot.runAsync(true);
    }

    /**
     * Ends the robot's session and the connection, whatever state they are in, then that of the laser, and the
     * reservation. Blocks for more than 1 s.
     */
    void disconnect() {
        try {
            robot.stopRunning(true);
            ArDeviceConnection open = device;
            if (open != null) {
                open.close();
            }
            laser.disconnect();
        } finally {
            inUse.set(false);
        }
    }
}
