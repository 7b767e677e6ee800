package majic.nav;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.ArrayDeque;
import java.util.Deque;
import majic.bot.MajicBot;
import majic.bot.RangeScan;
import majic.bot.ScanListener;
import majic.time.Signal;
import org.jspecify.annotations.Nullable;

/**
 * A thread that works on the scans of one robot, one after the other, so that nothing the robot does waits for it. Once
 * the robot has measured with a laser scanner, only its scans count. Thread-safe.
 */
final class ScanThread implements ScanListener {
    private static final Logger LOG = System.getLogger(ScanThread.class.getName());

    /** Some scans take some hundred milliseconds; the oldest of a longer time are left out. */
    private static final int MOST_WAITING = 30;

    private final MajicBot robot;
    private final String name;
    private final TeamSpace team;
    private final Work work;
    private final Signal changed;
    private final Deque<RangeScan> waiting = new ArrayDeque<>();
    private boolean ending;
    private boolean ended;

    /** What is done with the scans, on that thread. */
    interface Work {
        /**
         * Takes in a scan.
         *
         * @param laser whether it is of a laser scanner
         */
        void add(RangeScan scan, boolean laser);

        /** Ends after the last scan. */
        default void finish() {}

        /** Ends because of an error, which has been logged. */
        void failed();
    }

    /**
     * A thread that {@link #begin} starts.
     *
     * @param robot with range sensors
     * @param name of the thread
     * @param team knows the other robots, of which the echoes are left out
     * @param work what it does
     */
    ScanThread(MajicBot robot, String name, TeamSpace team, Work work) {
        this.robot = robot;
        this.team = team;
        this.name = name;
        this.work = work;
        this.changed = robot.time().signal();
    }

    /** Asks the robot for its scans from now on. */
    void begin() {
        robot.time().thread(name, this::run).start();
        robot.addScanListener(this);
    }

    @Override
    public void scanned(RangeScan scan) {
        synchronized (this) {
            if (ending) {
                return;
            }
            if (waiting.size() == MOST_WAITING) {
                waiting.removeFirst();
            }
            waiting.addLast(scan);
        }
        changed.raise();
    }

    /** Takes in no more scans than those that wait, and returns at once. */
    void end() {
        robot.removeScanListener(this);
        synchronized (this) {
            ending = true;
        }
        changed.raise();
    }

    /**
     * Waits until the work has ended.
     *
     * @param seconds the longest wait, on the clock of the robot
     */
    void awaitEnd(double seconds) {
        try {
            changed.await(this::hasEnded, seconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private synchronized boolean hasEnded() {
        return ended;
    }

    private synchronized boolean isDue() {
        return ending || !waiting.isEmpty();
    }

    private synchronized @Nullable RangeScan next() {
        return waiting.pollFirst();
    }

    private void run() {
        boolean hasLaser = false;
        try {
            while (changed.await(this::isDue, Signal.FOR_EVER)) {
                RangeScan scan = next();
                if (scan == null) {
                    break;
                }
                boolean laser = scan.sensor().isLaser();
                hasLaser |= laser;
                if (laser || !hasLaser) {
                    work.add(team.withoutOthers(robot, scan), laser);
                }
            }
            work.finish();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (RuntimeException | Error e) {
            LOG.log(Level.ERROR, name + " with " + robot.name() + " has ended", e);
            work.failed();
        } finally {
            robot.removeScanListener(this);
            synchronized (this) {
                ended = true;
            }
            changed.raise();
        }
    }
}
