package majic.nav.mapping;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import majic.bot.Pose;

/**
 * Finds earlier visits to the place of the newest scan and adds them to the graph as loops.
 *
 * <p>Where the way there is certain to {@value #CERTAIN_MM} mm, the scan's own match is enough. Otherwise another place
 * may look alike: the last ten scans together must fit as well, and three such matches on the way must agree on one
 * correction before all three are added (the test of Olson 2009, of pairs instead of clusters).
 */
final class LoopCloser {
    /** The share of echoes that must lie on known surfaces: more than half, since the room may have changed. */
    private static final double LEAST_RESPONSE = 0.6;

    /** The score of the search; lower than the response, which is taken after the refinement. */
    private static final double LEAST_SCORE = 0.4;

    /** Earlier scans within this distance see the same surfaces; in addition to the uncertainty of the way. */
    private static final double NEAR_MM = 3000;

    /** By how much a difference of the heading counts as distance: at 90 degrees, half of the view is another one. */
    private static final double MM_PER_DEG = 20;

    /** Scans on each side of an earlier one that are matched with it. */
    private static final int AROUND = 8;

    private static final int TOGETHER = 10;

    /** A place is ambiguous if the scan fits this much as well without a correction. */
    private static final double AMBIGUOUS = 0.5;

    /** Visits to one place are apart by at least this many scans that are farther away. */
    private static final int APART = 5;

    private static final int MOST_VISITS = 2;
    private static final int HIGHEST_LEVEL = 6;

    static final double CERTAIN_MM = 300;

    /** The search is limited to three times this, 10 m: beyond it, places that look alike are too many. */
    private static final double MOST_SIGMA_MM = 3300;

    private static final double LEAST_SIGMA_MM = 50;
    private static final double LEAST_SIGMA_DEG = 1;
    private static final double MOST_SIGMA_DEG = 10;

    /** Matches that agree, with the one that is checked. */
    private static final int AGREEING = 3;

    private static final double AGREE_MM = 300;
    private static final double AGREE_DEG = 3;
    private static final int MOST_AGE = 30;

    /** A loop that fits worse than this moves the poses at once. */
    private static final double SURPRISE = 3;

    /** A match that waits for others that agree. */
    private record Pending(int from, int to, ScanMatch match) {}

    private record Visit(int key, double cost) {}

    private final KeyScans keys;
    private final int recent;
    private final List<Pending> pending = new ArrayList<>();
    private int loops;

    /**
     * Makes one.
     *
     * @param recent the number of scans that each new one is matched to anyway
     */
    LoopCloser(KeyScans keys, int recent) {
        this.keys = keys;
        this.recent = recent;
    }

    int loops() {
        return loops;
    }

    /** Looks for loops of the newest scan; returns whether the graph has to be optimised. */
    boolean close() {
        int newest = keys.size() - 1;
        PoseGraph.Variances variances = keys.graph().seenFrom(newest);
        boolean surprise = false;
        for (Visit visit : visits(newest, variances)) {
            int key = visit.key();
            double sigmaMm =
                    Math.min(MOST_SIGMA_MM, LEAST_SIGMA_MM + Math.sqrt(variances.mm2()[key]));
            double sigmaDeg = Math.min(
                    MOST_SIGMA_DEG,
                    LEAST_SIGMA_DEG + Math.toDegrees(Math.sqrt(variances.rad2()[key])));
            SearchWindow window = new SearchWindow(keys.pose(newest), sigmaMm, sigmaDeg);
            surprise |= match(key, newest, window);
        }
        return surprise;
    }

    /** Forgets the matches that wait, whose places the optimisation has changed. */
    void corrected() {
        pending.clear();
    }

    /** The earlier scans that are nearest, one of each visit, the best first. */
    private List<Visit> visits(int newest, PoseGraph.Variances variances) {
        List<Visit> visits = new ArrayList<>();
        Visit best = null;
        int last = 0;
        for (int key = 0; key <= newest - recent; key++) {
            double cost = cost(key, newest, variances.mm2()[key]);
            if (cost == Double.POSITIVE_INFINITY) {
                continue;
            }
            if (best != null && key - last > APART) {
                visits.add(best);
                best = null;
            }
            last = key;
            if (best == null || cost < best.cost()) {
                best = new Visit(key, cost);
            }
        }
        if (best != null) {
            visits.add(best);
        }
        visits.sort(Comparator.comparingDouble(Visit::cost));
        return visits.subList(0, Math.min(MOST_VISITS, visits.size()));
    }

    private double cost(int key, int newest, double mm2) {
        Pose here = keys.pose(newest);
        double distance = keys.pose(key).distanceMm(here);
        if (distance > NEAR_MM + 3 * Math.min(MOST_SIGMA_MM, Math.sqrt(mm2))) {
            return Double.POSITIVE_INFINITY;
        }
        return distance + MM_PER_DEG * Math.abs(Pose.normalised(keys.pose(key).headingDeg() - here.headingDeg()));
    }

    private boolean match(int key, int newest, SearchWindow window) {
        ReferenceGrid reference =
                new ReferenceGrid(keys.placed(key - AROUND, Math.min(key + AROUND, newest - recent)), HIGHEST_LEVEL);
        Optional<ScanMatch> match = ScanMatcher.match(
                        reference, keys.points(newest), window, Information.NONE, LEAST_SCORE)
                .filter(found -> found.response() > LEAST_RESPONSE);
        if (match.isEmpty()) {
            return false;
        }
        if (window.sigmaMm() <= CERTAIN_MM) {
            return add(new Pending(key, newest, match.get()));
        }
        return fitsTogether(reference, newest, match.get().pose())
                && !isAmbiguous(reference, newest, match.get())
                && agrees(new Pending(key, newest, match.get()));
    }

    /** Whether the scan fits nearly as well where it is now: then the match may be a place that looks alike. */
    private boolean isAmbiguous(ReferenceGrid reference, int newest, ScanMatch found) {
        Pose here = keys.pose(newest);
        SearchWindow near = new SearchWindow(here, CERTAIN_MM / 3, MOST_SIGMA_DEG / 3);
        return found.pose().distanceMm(here) > CERTAIN_MM
                && ScanMatcher.match(reference, keys.points(newest), near, Information.NONE, 0)
                        .filter(other -> other.response() > AMBIGUOUS * found.response())
                        .isPresent();
    }

    private boolean fitsTogether(ReferenceGrid reference, int newest, Pose pose) {
        EchoPoints together = EchoPoints.joined(keys.placed(newest - TOGETHER + 1, newest), keys.pose(newest));
        return ScanMatcher.refine(reference, together, pose, pose, Information.NONE)
                .filter(found ->
                        found.response() > LEAST_RESPONSE && found.pose().distanceMm(pose) < AGREE_MM)
                .isPresent();
    }

    /** Adds a match and those that agree with it, if they are enough; else keeps it. */
    private boolean agrees(Pending candidate) {
        pending.removeIf(other -> candidate.to() - other.to() > MOST_AGE);
        List<Pending> agreeing = pending.stream()
                .filter(other -> other.to() != candidate.to() && agree(other, candidate))
                .toList();
        if (agreeing.size() < AGREEING - 1) {
            pending.add(candidate);
            return false;
        }
        agreeing.forEach(this::add);
        pending.removeAll(agreeing);
        return add(candidate);
    }

    /** Whether the correction of one match would take the other scan to where its own match puts it. */
    private boolean agree(Pending one, Pending other) {
        Pose correction = one.match().pose().plus(Pose.START.originOf(keys.pose(one.to())));
        Pose predicted = correction.plus(keys.pose(other.to()));
        Pose is = other.match().pose();
        return predicted.distanceMm(is) < AGREE_MM
                && Math.abs(Pose.normalised(predicted.headingDeg() - is.headingDeg())) < AGREE_DEG;
    }

    private boolean add(Pending loop) {
        loops++;
        return keys.graph().misfit(keys.connect(loop.from(), loop.to(), loop.match(), true)) > SURPRISE;
    }
}
