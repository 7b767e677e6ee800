package majic.nav;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Consumer;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.bot.ScanListener;
import majic.nav.grid.GridBuilder;
import majic.nav.grid.OccupancyGrid;
import majic.nav.mapping.Mapper;
import majic.time.Signal;
import org.jspecify.annotations.Nullable;

/**
 * Builds a map of what one robot measures while it drives, on a thread of its own. The frame of the map is that of the
 * robot's poses when the first scan comes. With a laser scanner the scans are matched, and the robot is placed where
 * the map has it, whenever its odometry has become wrong. The few wide beams of sonars say too little of the place:
 * they are drawn where the odometry has the robot. Thread-safe.
 */
final class LiveMapping implements ScanListener {
    private static final Logger LOG = System.getLogger(LiveMapping.class.getName());

    /** A loop that closes takes some hundred milliseconds; the oldest scans of a longer time are left out. */
    private static final int MOST_WAITING = 30;

    /** The time between two drawings of the grid, seconds. */
    private static final double DRAW_S = 1;

    /** The robot is placed anew if it is as far from where the map has it. */
    private static final double WRONG_MM = 30;

    private static final double WRONG_DEG = 1;

    /** The least beams of a laser scanner, and their widest opening. */
    private static final int LASER_BEAMS = 30;

    private static final double LASER_DEG = 5;

    private final MajicBot robot;
    private final Consumer<OccupancyGrid> drawn;
    private final Signal changed;
    private final Mapper mapper = new Mapper();
    private final GridBuilder coarse = new GridBuilder();
    private boolean laser;
    private final Deque<RangeScan> waiting = new ArrayDeque<>();
    private boolean ending;
    private boolean ended;
    private @Nullable Pose frame;
    private volatile int scans;
    private volatile int loops;

    /**
     * A mapping that {@link #begin} begins.
     *
     * @param robot with range sensors
     * @param drawn receives the map, in the frame of the robot's poses, each time it has become another one
     */
    LiveMapping(MajicBot robot, Consumer<OccupancyGrid> drawn) {
        this.robot = robot;
        this.drawn = drawn;
        this.changed = robot.time().signal();
    }

    /** Asks the robot for its scans from now on. */
    void begin() {
        robot.time().thread("mapping", this::run).start();
        robot.addScanListener(this);
    }

    /** The robot that is driven. */
    MajicBot robot() {
        return robot;
    }

    /** The scans that are in the map so far. */
    int scans() {
        return scans;
    }

    /** The loops that were closed so far. */
    int loops() {
        return loops;
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

    /**
     * Ends it: what has been measured so far is added, and all poses are fitted once more.
     *
     * @param seconds the longest wait for the last map, on the clock of the robot
     */
    void end(double seconds) {
        robot.removeScanListener(this);
        synchronized (this) {
            ending = true;
        }
        changed.raise();
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
        long drawnNanos = robot.time().nanos();
        boolean fresh = false;
        try {
            while (changed.await(this::isDue, Signal.FOR_EVER)) {
                RangeScan scan = next();
                if (scan == null) {
                    break;
                }
                fresh |= add(scan);
                if (fresh && (scans == 1 || robot.time().secondsSince(drawnNanos) >= DRAW_S)) {
                    draw();
                    drawnNanos = robot.time().nanos();
                    fresh = false;
                }
            }
            if (laser) {
                mapper.finish();
            }
            draw();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (RuntimeException | Error e) {
            LOG.log(Level.ERROR, "mapping with " + robot.name() + " has ended", e);
        } finally {
            robot.removeScanListener(this);
            synchronized (this) {
                ended = true;
            }
            changed.raise();
        }
    }

    private boolean add(RangeScan scan) {
        boolean fine = isLaser(scan.sensor());
        if (frame == null || fine && !laser) {
            frame = robot.odometryOrigin().plus(scan.odometry());
        }
        laser |= fine;
        if (!laser) {
            coarse.add(scan, robot.odometryOrigin().plus(scan.odometry()));
            scans++;
            return true;
        }
        if (!fine || !mapper.add(scan)) {
            return false;
        }
        scans = mapper.scans();
        loops = mapper.loops();
        place(frame.plus(mapper.origin()));
        return true;
    }

    private static boolean isLaser(RangeSensor sensor) {
        return sensor.beams().size() >= LASER_BEAMS
                && sensor.beams().stream().allMatch(beam -> beam.openingDeg() <= LASER_DEG);
    }

    /** Corrects the frame of the robot's odometry, not the odometry, by which it moves. */
    private void place(Pose origin) {
        Pose wrong = robot.odometryOrigin().seenFrom(origin);
        Pose now = robot.state().pose();
        Pose right = origin.plus(now.seenFrom(robot.odometryOrigin()));
        if (now.distanceMm(right) > WRONG_MM || Math.abs(wrong.headingDeg()) > WRONG_DEG) {
            robot.place(right);
        }
    }

    private void draw() {
        Pose origin = frame;
        if (origin != null) {
            drawn.accept(laser ? mapper.grid().movedInto(origin) : coarse.toGrid());
        }
    }
}
