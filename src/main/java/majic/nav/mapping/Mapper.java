package majic.nav.mapping;

import java.util.Optional;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.nav.grid.GridBuilder;
import majic.nav.grid.OccupancyGrid;

/**
 * Builds a map from the scans and the odometry of one robot: each scan is matched to the last {@value #RECENT}, earlier
 * visits to the same place are found and verified, and all poses are fitted to all matches (Lu and Milios 1997;
 * Grisetti 2010). The frame of the map has its origin at the first scan.
 *
 * <p>A scan is kept if the robot has moved by {@value #KEY_MM} mm or turned by {@value #KEY_DEG} degrees since the last
 * one that was kept; between them, odometry is added to the last one. Up to {@value #MOST_SCANS} scans with
 * {@value #MOST_ECHOES} echoes are kept, in at most 200 MB; later ones are left out ({@link #isFull}).
 *
 * <p>Not thread-safe. A scan takes some milliseconds, one that closes a loop of a large map some hundred.
 */
public final class Mapper {
    /** The most scans that are kept: about 6 km of way. */
    public static final int MOST_SCANS = 20_000;

    /** The most echoes that are kept, 16 bytes each. */
    public static final int MOST_ECHOES = 5_000_000;

    /** Scans at this distance overlap nearly completely. */
    static final double KEY_MM = 300;

    static final double KEY_DEG = 15;

    /** About 10 m of way: more than a scanner sees around corners, less than what odometry drifts on. */
    static final int RECENT = 25;

    /** So few echoes on known surfaces that the prediction is better. */
    private static final double LEAST_SCORE = 0.2;

    private static final int LEVELS = 3;
    private static final int ITERATIONS = 12;
    private static final int LAST_ITERATIONS = 30;

    private final KeyScans keys = new KeyScans();
    private final LoopCloser loops = new LoopCloser(keys, RECENT);
    private GridBuilder grid = new GridBuilder();
    private int drawn;

    /**
     * Adds a scan.
     *
     * @param scan its odometry in the same frame as that of the scans before
     * @return whether it was kept
     */
    public boolean add(RangeScan scan) {
        if (isFull()) {
            return false;
        }
        EchoPoints points = EchoPoints.of(scan);
        if (keys.size() == 0) {
            keys.add(scan, points, Pose.START);
            return true;
        }
        int last = keys.size() - 1;
        Pose moved = scan.odometry().seenFrom(keys.scan(last).odometry());
        double way = Math.hypot(moved.xMm(), moved.yMm());
        double turn = Math.abs(moved.headingDeg());
        if (way < KEY_MM && turn < KEY_DEG) {
            return false;
        }
        SearchWindow window = SearchWindow.afterMotion(keys.pose(last), moved);
        ScanMatch match = match(points, window);
        keys.add(scan, points, match.pose());
        keys.connect(last, last + 1, match, false);
        if (loops.close()) {
            optimise(ITERATIONS);
        }
        return true;
    }

    /** Matches the newest scan to the last ones; the prediction, with its uncertainty, if it fits nowhere. */
    private ScanMatch match(EchoPoints points, SearchWindow window) {
        Information prior = Information.ofSigmas(window.sigmaMm(), window.sigmaDeg());
        ReferenceGrid reference = new ReferenceGrid(keys.placed(keys.size() - RECENT, keys.size() - 1), LEVELS);
        Optional<ScanMatch> match = ScanMatcher.match(reference, points, window, prior, LEAST_SCORE);
        return match.orElseGet(() -> new ScanMatch(window.centre(), 0, prior.inverse()));
    }

    private void optimise(int iterations) {
        keys.graph().optimise(iterations);
        loops.corrected();
        grid = new GridBuilder();
        drawn = 0;
    }

    /** Fits all poses once more, after the last scan. */
    public void finish() {
        optimise(LAST_ITERATIONS);
    }

    /** Returns whether the limits are reached, so that no scan is kept any more. */
    public boolean isFull() {
        return keys.size() >= MOST_SCANS || keys.echoes() >= MOST_ECHOES;
    }

    /** Returns the number of scans that were kept. */
    public int scans() {
        return keys.size();
    }

    /** Returns the number of loops that were added. */
    public int loops() {
        return loops.loops();
    }

    /**
     * Returns a scan at its place on the map, as far as it is known now.
     *
     * @param index of the scans that were kept, from 0
     * @return the scan with its own odometry
     */
    public RangeScan scan(int index) {
        return keys.scan(index);
    }

    /**
     * Returns the place of a scan on the map, as far as it is known now.
     *
     * @param index of the scans that were kept, from 0
     * @return the pose of the robot's centre
     */
    public Pose pose(int index) {
        return keys.pose(index);
    }

    /**
     * Returns the frame of the odometry, seen from the map: added in front of a pose of the odometry since the last
     * scan, it gives the pose on the map.
     *
     * @return the pose for which {@code origin().plus(odometry)} is on the map; the start before the first scan
     */
    public Pose origin() {
        int last = keys.size() - 1;
        return last < 0 ? Pose.START : keys.pose(last).originOf(keys.scan(last).odometry());
    }

    /**
     * Returns the map: made anew after a correction of the poses, else completed.
     *
     * @return an occupancy grid of all scans that were kept
     */
    public OccupancyGrid grid() {
        for (; drawn < keys.size(); drawn++) {
            grid.add(keys.scan(drawn), keys.pose(drawn));
        }
        return grid.toGrid();
    }
}
