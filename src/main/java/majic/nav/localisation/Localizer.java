package majic.nav.localisation;

import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import majic.bot.Beam;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.Uncertainty;
import majic.nav.grid.LikelihoodField;
import majic.nav.grid.OccupancyGrid;
import majic.nav.grid.OccupancyGrid.State;
import majic.nav.mapping.ScanOdometry;
import org.jspecify.annotations.Nullable;

/**
 * Finds a robot on a map by particles (Dellaert, Fox, Burgard, Thrun 1999) with a likelihood field. While it looks
 * everywhere, scans that fit worse than those before add particles from anywhere (augmented MCL; Thrun, Burgard, Fox
 * 2005, 8.3.3). A robot that was carried away is noticed by scans that contradict the map for {@value #STEADY} updates,
 * and is looked for again; if they only fit badly, it is looked for elsewhere while it is tracked. Echoes in what is
 * unknown do not count, so that a robot in a room that is not on the map keeps its place by odometry.
 *
 * <p>An estimate is placed if one group of particles has nearly all weight and its scans have fitted the map for
 * {@value #STEADY} updates; a wrong group rarely survives so many. A scan counts if the robot has moved by 100 mm or
 * turned by 5 degrees since the last one. Scans of several sensors may be mixed, also sonars. Not thread-safe; an
 * update takes a millisecond when placed and up to 0.2 s at the beginning of a global search.
 */
public final class Localizer {
    /** From so many beams on, scans of a sensor are matched to each other, since that is better than odometry. */
    private static final int DENSE = 60;

    /** The share of the errors of odometry that is left after matching. */
    private static final double MATCHED = 0.2;

    private static final double STEP_MM = 100;
    private static final double STEP_DEG = 5;

    /** Of a scan, at most so many echoes are compared: neighbouring ones say the same. */
    private static final int MOST_ECHOES = 60;

    /** The most independent echoes of a scan, as in the scan matcher, halved for what is not on the map. */
    private static final double INDEPENDENT = 15;

    /** The standard deviation of an echo: two cells. */
    private static final double SIGMA_MM = 100;

    /** The share of echoes of what is not on the map (z_rand). */
    private static final double RANDOM = 0.1;

    /** The logarithm of the likelihood of an echo in what is unknown: between that of agreement and that of none. */
    private static final double NEUTRAL = -1;

    /** The same for a robot that would stand in a wall, in all. */
    private static final double IN_A_WALL = -100;

    /** A wide beam has its echo somewhere on an arc, of which so many points are compared. */
    private static final int RAYS = 5;

    private static final int TRIALS = 100_000;

    /** Of these, so many are moved to the best place nearby, by steps from 200 mm and 8 degrees down to an eighth. */
    private static final int REFINED = 2000;

    private static final double FINEST = 0.125;
    private static final List<Pose> ASIDE = List.of(
            new Pose(200, 0, 0),
            new Pose(-200, 0, 0),
            new Pose(0, 200, 0),
            new Pose(0, -200, 0),
            new Pose(0, 0, 8),
            new Pose(0, 0, -8));

    private static final double SLOW = 0.02;
    private static final double FAST = 0.2;

    private static final double DOMINANT = 0.95;
    private static final double MOST_SIGMA_MM = 400;

    /** Echoes within 200 mm of a wall of the map: at least so many of the scans when placed. */
    private static final double FITS_MM = 200;

    private static final double LEAST_FIT = 0.85;

    /** A scan with fewer echoes in known parts of the map proves nothing. */
    private static final double LEAST_KNOWN = 0.6;

    /** Below this share for as many updates, a robot has been carried away. */
    private static final double LOST_FIT = 0.6;

    private static final int STEADY = 10;

    /** So far the robot has to drive while its scans fit; on a shorter way, parts of a building look alike. */
    private static final double STEADY_MM = 3000;

    /** Below this share for as many updates, it is looked for elsewhere as well, once in a hundred updates. */
    private static final double DOUBTFUL_FIT = 0.9;

    private static final int DOUBT_AGAIN = 100;

    /** Another place is taken if so many more of the echoes are near its walls. */
    private static final double FAR_BETTER = 0.15;

    private final LikelihoodField field;
    private final Random random;
    private Particles particles;
    private @Nullable Pose odometry;
    private @Nullable Pose newest;
    private boolean global;
    private double slow;
    private double fast;
    private double fit;
    private int steady;
    private double steadyMm;
    private int unfit;
    private int doubtful;
    private @Nullable Localizer rival;
    private final ScanOdometry matched = new ScanOdometry();
    private @Nullable Pose matchedPose;
    private boolean placed;
    private Particles.Group group = new Particles.Group(Pose.START, Uncertainty.UNKNOWN, 0);

    /**
     * Makes a localizer that looks everywhere.
     *
     * @param map what is occupied and free
     * @param seed of the random numbers; the same seed and scans give the same estimates
     */
    public Localizer(OccupancyGrid map, long seed) {
        this(new LikelihoodField(map), seed);
    }

    /**
     * Makes a localizer that looks everywhere.
     *
     * @param map the distances from its walls, which localizers of several robots may share
     * @param seed of the random numbers; the same seed and scans give the same estimates
     */
    public Localizer(LikelihoodField map, long seed) {
        this(map, new Random(seed));
    }

    private Localizer(LikelihoodField field, Random random) {
        this.field = field;
        this.random = random;
        particles = new Particles(random);
        search();
    }

    /** Forgets where the robot is, and looks everywhere from the next scan on. */
    public void search() {
        global = true;
        placed = false;
        steady = 0;
        steadyMm = 0;
        unfit = 0;
        fit = 0;
        slow = 0;
        fast = 0;
        doubtful = 0;
        rival = null;
        particles.clear();
    }

    /**
     * Places the robot, for instance where a user has put it on the map.
     *
     * @param pose on the map, at the last scan that was added, or at the first one if none was
     * @param sigmaMm the standard deviation of the place in each direction
     * @param sigmaDeg the standard deviation of the heading
     */
    public void place(Pose pose, double sigmaMm, double sigmaDeg) {
        search();
        global = false;
        placed = true;
        fit = 1;
        particles.scatter(pose, sigmaMm, sigmaDeg);
        group = particles.group();
        odometry = newest;
    }

    /**
     * Takes a scan into account.
     *
     * @param scan its odometry in the same frame as that of the scans before
     * @return whether the estimate has become another one
     */
    public boolean add(RangeScan scan) {
        newest = scan.odometry();
        Echoes echoes = Echoes.of(scan);
        if (echoes.count() == 0) {
            return false;
        }
        if (particles.count() == 0) {
            step(scan);
            odometry = newest;
            spread(echoes);
            return true;
        }
        if (odometry != null && isSmall(newest.seenFrom(odometry))) {
            return false;
        }
        Pose step = step(scan);
        double share = scan.size() >= DENSE ? MATCHED : 1;
        odometry = newest;
        particles.move(step, share);
        weigh(echoes);
        double lost = global ? Math.max(0, 1 - fast / slow) : 0;
        particles.resample(lost > 0.1 ? lost / 2 : 0, () -> best(echoes));
        group = particles.group();
        judge(echoes, step);
        if (placed) {
            doubt(scan);
        }
        return true;
    }

    /**
     * While the scans of a placed robot fit worse than usual, another localizer looks for it everywhere. If its place
     * fits far better, the robot is no longer placed; it is there if that place goes on fitting.
     */
    private void doubt(RangeScan scan) {
        doubtful = fit < DOUBTFUL_FIT ? doubtful + 1 : 0;
        if (doubtful == 0) {
            rival = null;
        } else if (doubtful % DOUBT_AGAIN == STEADY) {
            rival = new Localizer(field, random);
        }
        Localizer other = rival;
        if (other == null) {
            return;
        }
        other.add(scan);
        if (other.placed) {
            rival = null;
            if (other.fit > fit + FAR_BETTER) {
                particles = other.particles;
                group = other.group;
                fit = other.fit;
                placed = false;
                global = true;
                steady = 0;
                steadyMm = 0;
            }
        }
    }

    /** A turn shows as much that is new as a way. */
    private static double length(Pose step) {
        return Math.max(Math.hypot(step.xMm(), step.yMm()), Math.abs(step.headingDeg()) * STEP_MM / STEP_DEG);
    }

    private static boolean isSmall(Pose step) {
        return Math.hypot(step.xMm(), step.yMm()) < STEP_MM && Math.abs(step.headingDeg()) < STEP_DEG;
    }

    /** The motion since the last scan that counted; by matching the scans of a scanner, else by odometry. */
    private Pose step(RangeScan scan) {
        if (scan.size() < DENSE) {
            return scan.odometry().seenFrom(odometry == null ? scan.odometry() : odometry);
        }
        Pose to = matched.add(scan);
        Pose step = to.seenFrom(matchedPose == null ? to : matchedPose);
        matchedPose = to;
        return step;
    }

    /**
     * Returns where the robot is after the last scan and the given odometry.
     *
     * @param now the newest odometry
     * @return the estimate, moved by the odometry since the last scan that counted
     */
    public PoseEstimate estimate(Pose now) {
        Pose pose = odometry == null ? group.mean() : group.mean().plus(now.seenFrom(odometry));
        return new PoseEstimate(pose, group.uncertainty(), placed);
    }

    /** Returns the number of particles in use. */
    public int particles() {
        return particles.count();
    }

    /** The compared echoes in the robot's frame: of each, the points from which it may come. */
    private record Echoes(int count, int rays, double[] x, double[] y) {
        static Echoes of(RangeScan scan) {
            int rays = scan.sensor().isLaser() ? 1 : RAYS;
            double[] x = new double[rays * scan.size()];
            double[] y = new double[rays * scan.size()];
            int count = 0;
            double step = Math.max(1, scan.size() / (double) MOST_ECHOES);
            for (double at = 0; at < scan.size(); at += step) {
                int index = (int) at;
                float range = scan.rangeMm(index);
                if (!Float.isNaN(range) && !Float.isInfinite(range)) {
                    Beam beam = scan.sensor().beams().get(index);
                    for (int ray = 0; ray < rays; ray++) {
                        double aside = rays == 1 ? 0 : beam.openingDeg() * (ray / (rays - 1.0) - 0.5);
                        double angle = Math.toRadians(beam.mount().headingDeg() + aside);
                        x[rays * count + ray] = beam.mount().xMm() + range * Math.cos(angle);
                        y[rays * count + ray] = beam.mount().yMm() + range * Math.sin(angle);
                    }
                    count++;
                }
            }
            return new Echoes(count, rays, x, y);
        }

        /** Where the point in the middle of the beam is. */
        int middle(int echo) {
            return rays * echo + rays / 2;
        }
    }

    /** The logarithm of the likelihood of a scan at a pose, as of independent echoes; none in front of walls. */
    private double likelihood(Pose pose, Echoes echoes) {
        double angle = Math.toRadians(pose.headingDeg());
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        double sum = field.distanceMm(pose.xMm(), pose.yMm()) == 0 ? IN_A_WALL : 0;
        for (int index = 0; index < echoes.count(); index++) {
            double distance = distance(pose, cos, sin, echoes, index);
            sum += Double.isNaN(distance)
                    ? NEUTRAL
                    : Math.log(RANDOM + (1 - RANDOM) * Math.exp(-distance * distance / (2 * SIGMA_MM * SIGMA_MM)));
        }
        return sum / echoes.count();
    }

    /** From a wall to the nearest of the points from which an echo may come. */
    private double distance(Pose pose, double cos, double sin, Echoes echoes, int echo) {
        double least = Double.NaN;
        for (int at = echo * echoes.rays(); at < (echo + 1) * echoes.rays(); at++) {
            double distance = field.distanceMm(
                    pose.xMm() + cos * echoes.x()[at] - sin * echoes.y()[at],
                    pose.yMm() + sin * echoes.x()[at] + cos * echoes.y()[at]);
            least = Double.isNaN(least) || distance < least ? distance : least;
        }
        return least;
    }

    /** How well a scan fits the map at a pose: the share of its echoes in known parts, and that of these near walls. */
    private record Fit(double known, double near) {}

    private Fit fitAt(Pose pose, Echoes echoes) {
        double angle = Math.toRadians(pose.headingDeg());
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        int known = 0;
        int near = 0;
        for (int index = 0; index < echoes.count(); index++) {
            double distance = distance(pose, cos, sin, echoes, index);
            int middle = echoes.middle(index);
            boolean unknown = Double.isNaN(distance)
                    && !isBehindWall(
                            pose,
                            Math.hypot(echoes.x()[middle], echoes.y()[middle]),
                            angle + Math.atan2(echoes.y()[middle], echoes.x()[middle]));
            known += unknown ? 0 : 1;
            near += distance < FITS_MM ? 1 : 0;
        }
        return new Fit((double) known / echoes.count(), (double) near / Math.max(1, known));
    }

    /** Whether the way to an echo passes an occupied cell: there, the map is contradicted and not just unknown. */
    private boolean isBehindWall(Pose pose, double lengthMm, double angle) {
        double step = field.grid().cellMm();
        for (double at = step; at < lengthMm; at += step) {
            if (field.distanceMm(pose.xMm() + at * Math.cos(angle), pose.yMm() + at * Math.sin(angle)) == 0) {
                return true;
            }
        }
        return false;
    }

    /** A pose anywhere on the free floor. */
    private Pose anywhere() {
        OccupancyGrid grid = field.grid();
        for (int trial = 0; trial < TRIALS; trial++) {
            int column = random.nextInt(grid.width());
            int row = random.nextInt(grid.height());
            if (grid.state(column, row) == State.FREE) {
                Pose centre = grid.centre(column, row);
                return new Pose(centre.xMm(), centre.yMm(), 360 * random.nextDouble() - 180);
            }
        }
        return grid.centre(grid.width() / 2, grid.height() / 2);
    }

    /**
     * Draws many poses, keeps the best of each bin, and moves those to where the scan fits best nearby: too few poses
     * are drawn to hit each place by chance.
     */
    private void spread(Echoes echoes) {
        Map<Long, Candidate> best = new HashMap<>();
        for (int index = 0; index < TRIALS; index++) {
            Pose pose = anywhere();
            best.merge(Particles.bin(pose), new Candidate(pose, likelihood(pose, echoes)), Candidate::better);
        }
        particles.take(best.values().stream()
                .sorted(Comparator.comparingDouble(Candidate::likelihood).reversed())
                .limit(REFINED)
                .map(candidate -> refined(candidate, echoes).pose())
                .toList());
        particles.weigh(pose -> likelihood(pose, echoes), independent(echoes));
        particles.resampleMost();
        group = particles.group();
    }

    /** A pose with the logarithm of the likelihood of a scan. */
    private record Candidate(Pose pose, double likelihood) {
        Candidate better(Candidate other) {
            return other.likelihood > likelihood ? other : this;
        }
    }

    /** The best pose near one, by steps in each direction that are halved. */
    private Candidate refined(Candidate from, Echoes echoes) {
        Candidate best = from;
        for (double step = 1; step >= FINEST; step /= 2) {
            Candidate before;
            do {
                before = best;
                for (Pose aside : ASIDE) {
                    Pose pose = new Pose(
                            before.pose.xMm() + step * aside.xMm(),
                            before.pose.yMm() + step * aside.yMm(),
                            before.pose.headingDeg() + step * aside.headingDeg());
                    best = best.better(new Candidate(pose, likelihood(pose, echoes)));
                }
            } while (best != before);
        }
        return best;
    }

    /** As how many independent echoes a scan counts: a few sonars say less than a scanner. */
    private double independent(Echoes echoes) {
        return Math.min(echoes.count(), global ? INDEPENDENT / 2 : INDEPENDENT);
    }

    private void weigh(Echoes echoes) {
        double mean = particles.weigh(pose -> likelihood(pose, echoes), independent(echoes));
        slow += slow == 0 ? mean : SLOW * (mean - slow);
        fast += fast == 0 ? mean : FAST * (mean - fast);
    }

    /** The best of ten poses from anywhere. */
    private Pose best(Echoes echoes) {
        Pose best = anywhere();
        double most = likelihood(best, echoes);
        for (int trial = 1; trial < 10; trial++) {
            Pose other = anywhere();
            double likely = likelihood(other, echoes);
            if (likely > most) {
                best = other;
                most = likely;
            }
        }
        return best;
    }

    /** Decides whether the estimate may be relied on. */
    private void judge(Echoes echoes, Pose step) {
        Fit now = fitAt(group.mean(), echoes);
        if (now.known() > LEAST_KNOWN) {
            fit += (fit == 0 ? 1 : FAST) * (now.near() - fit);
            boolean agrees =
                    group.share() > DOMINANT && group.uncertainty().sigmaMm() < MOST_SIGMA_MM && fit > LEAST_FIT;
            steady = agrees ? steady + 1 : 0;
            steadyMm = agrees ? steadyMm + length(step) : 0;
        }
        unfit = fit < (global ? LEAST_FIT : LOST_FIT) ? unfit + 1 : 0;
        if (steady >= STEADY && steadyMm >= STEADY_MM) {
            placed = true;
            global = false;
        }
        if (unfit >= STEADY) {
            search();
        }
    }
}
