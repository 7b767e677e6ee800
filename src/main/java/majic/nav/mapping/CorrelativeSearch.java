package majic.nav.mapping;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import majic.bot.Pose;

/**
 * Finds the pose in a window at which the points of a scan agree best with a reference, whatever local maxima there
 * are: branch and bound over blocks of displacements, for each of a number of headings (Hess 2016, section V.B, after
 * Olson 2009). The result is exact to half a cell and half a step of the heading.
 */
final class CorrelativeSearch {
    /**
     * The number of independent echoes of a scan: neighbouring echoes have the same errors. It weighs the prediction
     * against the scan: score = mean likelihood × exp(−d² / 2n) for a pose d standard deviations from the prediction.
     */
    private static final double INDEPENDENT = 30;

    private static final double MIN_STEP_DEG = 0.25;
    private static final double MAX_STEP_DEG = 2;

    private final ReferenceGrid reference;
    private final SearchWindow window;
    private final int count;
    private final int reach;
    private final double stepDeg;
    private final List<Turned> turned = new ArrayList<>();
    private double best;
    private Candidate found;

    /** The points at one heading, as cells. */
    private record Turned(double headingDeg, int[] columns, int[] rows, double prior) {}

    /**
     * Displacements from (right, up) to (right, up) + 2^level − 1, at one heading, with an upper bound of their score.
     */
    private record Candidate(Turned points, int right, int up, int level, double bound) {}

    private CorrelativeSearch(ReferenceGrid reference, EchoPoints points, SearchWindow window, double least) {
        this.reference = reference;
        this.window = window;
        this.count = points.count;
        this.best = least;
        this.found = new Candidate(new Turned(0, new int[0], new int[0], 0), 0, 0, 0, 0);
        reach = (int) Math.ceil(window.reachMm() / ReferenceGrid.CELL_MM);
        double sum = 0;
        for (int index = 0; index < count; index++) {
            sum += Math.hypot(points.x[index], points.y[index]);
        }
        double stepRad = ReferenceGrid.CELL_MM / Math.max(1, sum / Math.max(1, count));
        stepDeg = Math.min(MAX_STEP_DEG, Math.max(MIN_STEP_DEG, Math.toDegrees(stepRad)));
        int steps = (int) Math.ceil(window.reachDeg() / stepDeg);
        for (int step = -steps; step <= steps; step++) {
            turned.add(turn(points, step * stepDeg));
        }
    }

    /**
     * Searches.
     *
     * @param least the score that the result exceeds, 0 to 1
     * @return the pose of the best score; empty if none exceeds {@code least}
     */
    static Optional<Pose> best(ReferenceGrid reference, EchoPoints points, SearchWindow window, double least) {
        CorrelativeSearch search = new CorrelativeSearch(reference, points, window, least);
        search.run();
        return search.best > least ? Optional.of(search.pose()) : Optional.empty();
    }

    private Turned turn(EchoPoints points, double byDeg) {
        Pose centre = window.centre();
        double angle = Math.toRadians(centre.headingDeg() + byDeg);
        double cos = Math.cos(angle) / ReferenceGrid.CELL_MM;
        double sin = Math.sin(angle) / ReferenceGrid.CELL_MM;
        double left = (centre.xMm() - reference.minX) / ReferenceGrid.CELL_MM;
        double low = (centre.yMm() - reference.minY) / ReferenceGrid.CELL_MM;
        int[] columns = new int[count];
        int[] rows = new int[count];
        for (int index = 0; index < count; index++) {
            columns[index] = (int) Math.floor(left + cos * points.x[index] - sin * points.y[index]);
            rows[index] = (int) Math.floor(low + sin * points.x[index] + cos * points.y[index]);
        }
        double sigmas = byDeg / window.sigmaDeg();
        return new Turned(byDeg, columns, rows, Math.exp(-sigmas * sigmas / (2 * INDEPENDENT)));
    }

    private void run() {
        int top = reference.highestLevel();
        while (top > 0 && (1 << top) > reach) {
            top--;
        }
        int block = 1 << top;
        List<Candidate> candidates = new ArrayList<>();
        for (Turned points : turned) {
            for (int up = -reach; up <= reach; up += block) {
                for (int right = -reach; right <= reach; right += block) {
                    add(candidates, points, right, up, top);
                }
            }
        }
        descend(candidates);
    }

    private void add(List<Candidate> candidates, Turned points, int right, int up, int level) {
        double score = points.prior()
                * reference.sum(points.columns(), points.rows(), count, right, up, level)
                / ((double) ReferenceGrid.FULL * Math.max(1, count));
        double bound = score * displaced(nearestToZero(right, level), nearestToZero(up, level));
        if (bound > best) {
            candidates.add(new Candidate(points, right, up, level, bound));
        }
    }

    private static int nearestToZero(int from, int level) {
        int to = from + (1 << level) - 1;
        return from > 0 ? from : Math.min(to, 0);
    }

    private double displaced(int right, int up) {
        double sigmas = ReferenceGrid.CELL_MM / window.sigmaMm();
        return Math.exp(-sigmas * sigmas * (right * right + up * up) / (2 * INDEPENDENT));
    }

    private void descend(List<Candidate> candidates) {
        candidates.sort(Comparator.comparingDouble(Candidate::bound).reversed());
        for (Candidate candidate : candidates) {
            if (candidate.bound() <= best) {
                return;
            }
            if (candidate.level() == 0) {
                best = candidate.bound();
                found = candidate;
                return;
            }
            int half = 1 << (candidate.level() - 1);
            List<Candidate> parts = new ArrayList<>(4);
            for (int part = 0; part < 4; part++) {
                add(
                        parts,
                        candidate.points(),
                        candidate.right() + (part & 1) * half,
                        candidate.up() + (part >> 1) * half,
                        candidate.level() - 1);
            }
            descend(parts);
        }
    }

    private Pose pose() {
        Pose centre = window.centre();
        return new Pose(
                centre.xMm() + found.right() * ReferenceGrid.CELL_MM,
                centre.yMm() + found.up() * ReferenceGrid.CELL_MM,
                centre.headingDeg() + found.points().headingDeg());
    }
}
