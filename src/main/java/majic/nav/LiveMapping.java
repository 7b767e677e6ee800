package majic.nav;

import java.util.function.Consumer;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.Uncertainty;
import majic.nav.grid.GridBuilder;
import majic.nav.grid.OccupancyGrid;
import majic.nav.mapping.Mapper;
import org.jspecify.annotations.Nullable;

/**
 * Builds a map of what one robot measures while it drives. The frame of the map is that of the robot's poses when the
 * first scan comes. With a laser scanner the scans are matched, and the robot is placed where the map has it, whenever
 * its odometry has become wrong. The few wide beams of sonars say too little of the place: they are drawn where the
 * odometry has the robot.
 */
final class LiveMapping implements ScanThread.Work {
    /** The time between two drawings of the grid, seconds. */
    private static final double DRAW_S = 1;

    /** The pose of the robot is corrected if it is as far from where the map has it. */
    private static final double WRONG_MM = 30;

    private static final double WRONG_DEG = 1;

    /** The robot is right by the map itself; what is left are a cell and half a degree. */
    private static final Uncertainty ON_ITS_OWN_MAP = Uncertainty.of(50, 0.5);

    private final MajicBot robot;
    private final Consumer<OccupancyGrid> drawn;
    private final Runnable failed;
    private final ScanThread thread;
    private final Mapper mapper = new Mapper();
    private final GridBuilder coarse = new GridBuilder();
    private boolean laser;
    private boolean fresh;
    private long drawnNanos;
    private @Nullable Pose frame;
    private volatile int scans;
    private volatile int loops;

    /**
     * A mapping that {@link #begin} begins.
     *
     * @param robot with range sensors
     * @param team knows the other robots, which are not drawn
     * @param drawn receives the map, in the frame of the robot's poses, each time it has become another one
     * @param failed called if it ends by an error
     */
    LiveMapping(MajicBot robot, TeamSpace team, Consumer<OccupancyGrid> drawn, Runnable failed) {
        this.robot = robot;
        this.drawn = drawn;
        this.failed = failed;
        this.thread = new ScanThread(robot, "mapping", team, this);
    }

    /** Asks the robot for its scans from now on. */
    void begin() {
        thread.begin();
    }

    /** The scans that are in the map so far. */
    int scans() {
        return scans;
    }

    /** The loops that were closed so far. */
    int loops() {
        return loops;
    }

    /**
     * Ends it: what has been measured so far is added, and all poses are fitted once more.
     *
     * @param seconds the longest wait for the last map, on the clock of the robot
     */
    void end(double seconds) {
        thread.end();
        thread.awaitEnd(seconds);
    }

    @Override
    public void add(RangeScan scan, boolean fine) {
        if (frame == null || fine && !laser) {
            frame = robot.odometryOrigin().plus(scan.odometry());
            drawnNanos = robot.time().nanos();
        }
        laser |= fine;
        if (!laser) {
            coarse.add(scan, robot.odometryOrigin().plus(scan.odometry()));
            scans++;
            fresh = true;
        } else if (mapper.add(scan)) {
            scans = mapper.scans();
            loops = mapper.loops();
            place(frame.plus(mapper.origin()));
            fresh = true;
        }
        if (fresh && (scans == 1 || robot.time().secondsSince(drawnNanos) >= DRAW_S)) {
            draw();
            drawnNanos = robot.time().nanos();
            fresh = false;
        }
    }

    @Override
    public void finish() {
        if (laser) {
            mapper.finish();
        }
        draw();
    }

    @Override
    public void failed() {
        failed.run();
    }

    /** Corrects the frame of the robot's odometry, not the odometry, by which it moves. */
    private void place(Pose origin) {
        Pose wrong = robot.odometryOrigin().seenFrom(origin);
        Pose now = robot.state().pose();
        Pose right = origin.plus(now.seenFrom(robot.odometryOrigin()));
        boolean isWrong = now.distanceMm(right) > WRONG_MM || Math.abs(wrong.headingDeg()) > WRONG_DEG;
        robot.place(isWrong ? right : now, ON_ITS_OWN_MAP);
    }

    private void draw() {
        Pose origin = frame;
        if (origin != null) {
            drawn.accept(laser ? mapper.grid().movedInto(origin) : coarse.toGrid());
        }
    }
}
