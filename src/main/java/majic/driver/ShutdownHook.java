package majic.driver;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.text.LateLogger;
import majic.time.TimeSource;

/**
 * Stops and closes every connected robot when the Java program ends: by Ctrl-C, a signal of the system,
 * {@code System.exit} or the end of its last thread. Revokes all permissions to move first, then closes all robots in
 * parallel, and waits for them for at most {@value #BOUND_MS} ms. A program that is killed ({@code SIGKILL},
 * {@code Runtime.halt}) or crashes does not get there.
 *
 * <p>Serial ports stay usable meanwhile, see {@code SerialShutdownDelay} of {@code majic.link}. Thread-safe.
 */
public final class ShutdownHook {
    private static final Logger LOG = LateLogger.of(ShutdownHook.class);

    /** How long the end of the program waits for robots to stop and close, ms. */
    private static final int BOUND_MS = 1000;

    private static final String REASON = "the program is ending";
    private static final Object LOCK = new Object();
    private static final Set<Closing> CONNECTED = new LinkedHashSet<>();
    private static final List<Runnable> AFTERWARDS = new ArrayList<>();
    private static boolean installed;
    private static boolean ending;

    private ShutdownHook() {}

    /**
     * How a robot is closed at the end of the program.
     *
     * @param name what messages call it at that time
     * @param time its clock
     * @param revoke ends all motions for the reason given, and allows no other; quick
     * @param close stops and closes it
     */
    record Closing(Supplier<String> name, TimeSource time, Consumer<String> revoke, Runnable close) {}

    /**
     * Registers a task to run once all robots are closed, or could not be closed in time. Nothing is done if the
     * program is ending already.
     *
     * @param task runs on the hook's thread and delays the end of the program; what it throws is logged
     */
    public static void afterwards(Runnable task) {
        synchronized (LOCK) {
            AFTERWARDS.add(task);
            install();
        }
    }

    /**
     * Registers a robot that is about to be connected.
     *
     * @throws BotException if the program is ending; the robot must not be connected then
     */
    static void add(Closing bot) {
        synchronized (LOCK) {
            install();
            if (ending) {
                throw new BotException(REASON);
            }
            CONNECTED.add(bot);
        }
    }

    /** Lets go of a robot that is closed. */
    static void remove(Closing bot) {
        synchronized (LOCK) {
            CONNECTED.remove(bot);
            LOCK.notifyAll();
        }
    }

    private static void install() {
        if (!installed) {
            installed = true;
            try {
                Runtime.getRuntime().addShutdownHook(new Thread(ShutdownHook::run, "closing robots at the end"));
            } catch (IllegalStateException e) {
                LOG.log(Level.DEBUG, "the program is ending already", e);
                ending = true;
            }
        }
    }

    private static void run() {
        List<Closing> robots = begin();
        robots.forEach(bot -> bot.revoke().accept(REASON));
        robots.forEach(bot -> bot.time().runAsync("closing " + bot.name().get(), () -> attempt(bot.close())));
        awaitClosed();
        finish();
    }

    private static List<Closing> begin() {
        synchronized (LOCK) {
            ending = true;
            return List.copyOf(CONNECTED);
        }
    }

    /** Waits for those too that another thread has begun to close. */
    private static void awaitClosed() {
        long deadlineNanos = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(BOUND_MS);
        synchronized (LOCK) {
            try {
                for (long left = BOUND_MS; left > 0 && !CONNECTED.isEmpty(); left = millisUntil(deadlineNanos)) {
                    LOCK.wait(left);
                }
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
            CONNECTED.forEach(bot -> LOG.log(Level.WARNING, bot.name().get() + " could not be closed in time"));
        }
    }

    private static long millisUntil(long deadlineNanos) {
        return TimeUnit.NANOSECONDS.toMillis(deadlineNanos - System.nanoTime());
    }

    private static void finish() {
        List<Runnable> tasks;
        synchronized (LOCK) {
            tasks = List.copyOf(AFTERWARDS);
        }
        tasks.forEach(ShutdownHook::attempt);
    }

    private static void attempt(Runnable task) {
        try {
            task.run();
        } catch (RuntimeException | Error e) {
            LOG.log(Level.WARNING, "the end of the program goes on without this", e);
        }
    }
}
