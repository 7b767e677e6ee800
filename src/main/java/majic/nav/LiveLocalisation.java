package majic.nav;

import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Supplier;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.Uncertainty;
import majic.nav.grid.LikelihoodField;
import majic.nav.localisation.Localizer;
import majic.nav.localisation.PoseEstimate;
import org.jspecify.annotations.Nullable;

/**
 * Keeps the place of one robot on a map right while it drives: from where it was placed, or looking everywhere. A
 * person who places the robot is believed. A robot whose scans contradict the map has been carried away: its place
 * becomes unknown, and it is looked for everywhere.
 */
final class LiveLocalisation implements ScanThread.Work {
    /** Of random numbers. */
    private static final long SEED = 1;

    private final MajicBot robot;
    private final Supplier<LikelihoodField> map;
    private final Consumer<String> news;
    private final Runnable failed;
    private final ScanThread thread;
    private volatile boolean search;
    private volatile boolean ended;
    private boolean searching;
    private @Nullable Localizer localizer;
    private @Nullable Pose last;
    private @Nullable Pose placedHere;

    /**
     * A localisation that {@link #begin} begins.
     *
     * @param robot with range sensors
     * @param team knows the other robots, which are not on the map
     * @param map the distances from its walls, in the frame of the robot's poses; asked once, on a thread of its own
     * @param search whether to look everywhere; else from where it was placed
     * @param news receives half a sentence when the robot is lost or found
     * @param failed called if it ends by an error; the place is unknown then
     */
    LiveLocalisation(
            MajicBot robot,
            TeamSpace team,
            Supplier<LikelihoodField> map,
            boolean search,
            Consumer<String> news,
            Runnable failed) {
        this.robot = robot;
        this.map = map;
        this.search = search;
        this.news = news;
        this.failed = failed;
        this.thread = new ScanThread(robot, "localisation", team, this);
    }

    void begin() {
        thread.begin();
    }

    /** Forgets the place with the next scan, and looks everywhere. */
    void search() {
        search = true;
    }

    /** Corrects the place no longer: scans that still wait are not used, since there may be another map. */
    void end() {
        ended = true;
        thread.end();
    }

    @Override
    public void add(RangeScan scan, boolean laser) {
        if (ended) {
            return;
        }
        Localizer found = localizer == null ? new Localizer(map.get(), SEED) : localizer;
        localizer = found;
        if (search) {
            search = false;
            lose();
            found.search();
        } else if (isPlacedByOthers()) {
            believe(found, last == null ? scan.odometry() : last);
        }
        last = scan.odometry();
        if (found.add(scan) && !ended && !isPlacedByOthers()) {
            take(found.estimate(scan.odometry()), scan.odometry());
        }
    }

    /** Returns whether a person has placed the robot since it was placed here. */
    private boolean isPlacedByOthers() {
        return robot.placedAt().map(pose -> pose != placedHere).orElse(false);
    }

    /** Takes over where a person has put the robot since the last scan. */
    private void believe(Localizer found, Pose odometry) {
        Uncertainty given = robot.uncertainty();
        if (given.isKnown()) {
            placedHere = robot.placedAt().orElse(null);
            searching = false;
            found.place(robot.odometryOrigin().plus(odometry), given.sigmaMm(), given.sigmaDeg());
        }
    }

    private void take(PoseEstimate estimate, Pose odometry) {
        if (estimate.placed()) {
            Pose here = place(estimate, odometry);
            if (searching) {
                searching = false;
                news.accept(String.format(
                        Locale.ROOT,
                        "has found its place: x %.0f mm, y %.0f mm, heading %.0f deg",
                        here.xMm(),
                        here.yMm(),
                        here.headingDeg()));
            }
        } else if (!searching) {
            lose();
            news.accept(
                    "does not know where it is on the map: what it measures contradicts its place; it looks for it");
        }
    }

    /** Corrects the frame of the robot's odometry, not the odometry, by which it moves. */
    private Pose place(PoseEstimate estimate, Pose odometry) {
        Pose origin = estimate.pose().originOf(odometry);
        Pose right = origin.plus(robot.state().pose().seenFrom(robot.odometryOrigin()));
        placedHere = right;
        robot.place(right, estimate.uncertainty());
        return right;
    }

    private void lose() {
        searching = true;
        Pose guess = robot.state().pose();
        placedHere = guess;
        robot.place(guess, Uncertainty.UNKNOWN);
    }

    @Override
    public void failed() {
        lose();
        news.accept("is no longer followed on the map because of an error in MAJIC; the log has it");
        failed.run();
    }
}
