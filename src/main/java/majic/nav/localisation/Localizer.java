package majic.nav.localisation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import majic.bot.Beam;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.nav.grid.LikelihoodField;
import majic.nav.grid.OccupancyGrid;
import majic.nav.grid.OccupancyGrid.State;
import majic.nav.mapping.ScanOdometry;
import org.jspecify.annotations.Nullable;

/**
 * Finds a robot on a map by particles (Dellaert, Fox, Burgard, Thrun 1999) with a likelihood field, as many as the
 * uncertainty needs (KLD sampling, Fox 2003). While it looks everywhere, scans that fit worse than those before add
 * particles from anywhere (augmented MCL; Thrun, Burgard, Fox 2005, 8.3.3). A robot that was carried away is noticed by
 * scans that contradict the map for {@value #STEADY} updates, and is looked for again. Echoes in what is unknown do not
 * count, so that a robot in a room that is not on the map keeps its place by odometry.
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

    /** The number of independent echoes of a scan, as in the scan matcher, halved for what is not on the map. */
    private static final double INDEPENDENT = 15;

    /** The standard deviation of an echo: two cells. */
    private static final double SIGMA_MM = 100;

    /** The share of echoes of what is not on the map (z_rand). */
    private static final double RANDOM = 0.1;

    /** The logarithm of the likelihood of an echo in what is unknown: between that of agreement and that of none. */
    private static final double NEUTRAL = -1;

    private static final int LEAST = 500;
    private static final int MOST = 20_000;
    private static final int TRIALS = 100_000;

    /** KLD sampling: error 0.05 with probability 0.99 in bins of 0.5 m and 10 degrees (Fox 2003, section 4). */
    private static final double BIN_MM = 500;

    private static final double BIN_DEG = 10;
    private static final double ERROR = 0.05;
    private static final double QUANTILE = 2.33;

    private static final double SLOW = 0.02;
    private static final double FAST = 0.2;

    /** The group around the best bin: all particles within this. */
    private static final double GROUP_MM = 1000;

    private static final double GROUP_DEG = 30;
    private static final double DOMINANT = 0.95;
    private static final double MOST_SIGMA_MM = 400;

    /** Echoes within 200 mm of a wall of the map: at least so many of the scans when placed. */
    private static final double FITS_MM = 200;

    private static final double LEAST_FIT = 0.75;

    /** A scan with fewer echoes in known parts of the map proves nothing. */
    private static final double LEAST_KNOWN = 0.6;

    /** Below this share for as many updates, a robot has been carried away. */
    private static final double LOST_FIT = 0.4;

    private static final int STEADY = 10;

    private final LikelihoodField field;
    private final Random random;
    private List<Pose> particles = new ArrayList<>();
    private double[] weights = {};
    private @Nullable Pose odometry;
    private @Nullable Pose newest;
    private boolean global;
    private double slow;
    private double fast;
    private double fit;
    private int steady;
    private int unfit;
    private final ScanOdometry matched = new ScanOdometry();
    private @Nullable Pose matchedPose;
    private boolean placed;
    private double dominant;
    private PoseEstimate estimate = new PoseEstimate(Pose.START, 0, 0, 0, 180, false);

    /**
     * Makes a localizer that looks everywhere.
     *
     * @param map what is occupied and free
     * @param seed of the random numbers; the same seed and scans give the same estimates
     */
    public Localizer(OccupancyGrid map, long seed) {
        field = new LikelihoodField(map);
        random = new Random(seed);
        search();
    }

    /** Forgets where the robot is, and looks everywhere from the next scan on. */
    public void search() {
        global = true;
        placed = false;
        steady = 0;
        unfit = 0;
        fit = 0;
        slow = 0;
        fast = 0;
        particles = new ArrayList<>();
    }

    /**
     * Places the robot, for instance where a user has put it on the map.
     *
     * @param pose on the map
     * @param sigmaMm the standard deviation of the place in each direction
     * @param sigmaDeg the standard deviation of the heading
     */
    public void place(Pose pose, double sigmaMm, double sigmaDeg) {
        search();
        global = false;
        placed = true;
        fit = 1;
        for (int index = 0; index < LEAST; index++) {
            particles.add(new Pose(
                    pose.xMm() + sigmaMm * random.nextGaussian(),
                    pose.yMm() + sigmaMm * random.nextGaussian(),
                    pose.headingDeg() + sigmaDeg * random.nextGaussian()));
        }
        weights = equal(particles.size());
        summarise();
        odometry = newest;
    }

    /**
     * Takes a scan into account.
     *
     * @param scan its odometry in the same frame as that of the scans before
     */
    public void add(RangeScan scan) {
        newest = scan.odometry();
        Echoes echoes = Echoes.of(scan);
        if (echoes.count() == 0) {
            return;
        }
        if (particles.isEmpty()) {
            step(scan);
            odometry = newest;
            spread(echoes);
            return;
        }
        if (odometry != null && isSmall(newest.seenFrom(odometry))) {
            return;
        }
        Pose step = step(scan);
        double share = scan.size() >= DENSE ? MATCHED : 1;
        odometry = newest;
        particles.replaceAll(particle -> particle.plus(MotionModel.sample(step, share, random)));
        weigh(echoes);
        resample(echoes);
        summarise();
        judge(echoes);
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
        return odometry == null
                ? estimate
                : new PoseEstimate(
                        estimate.pose().plus(now.seenFrom(odometry)),
                        estimate.varianceXmm2(),
                        estimate.covarianceXYmm2(),
                        estimate.varianceYmm2(),
                        estimate.sigmaDeg(),
                        estimate.placed());
    }

    /** Returns the number of particles in use. */
    public int particles() {
        return particles.size();
    }

    /** The compared echoes in the robot's frame. */
    private record Echoes(int count, double[] x, double[] y) {
        static Echoes of(RangeScan scan) {
            double[] x = new double[scan.size()];
            double[] y = new double[scan.size()];
            int count = 0;
            double step = Math.max(1, scan.size() / (double) MOST_ECHOES);
            for (double at = 0; at < scan.size(); at += step) {
                int index = (int) at;
                float range = scan.rangeMm(index);
                if (!Float.isNaN(range) && !Float.isInfinite(range)) {
                    Beam beam = scan.sensor().beams().get(index);
                    double angle = Math.toRadians(beam.mount().headingDeg());
                    x[count] = beam.mount().xMm() + range * Math.cos(angle);
                    y[count++] = beam.mount().yMm() + range * Math.sin(angle);
                }
            }
            return new Echoes(count, x, y);
        }
    }

    /** The logarithm of the likelihood of a scan at a pose, as of independent echoes; none in front of walls. */
    private double likelihood(Pose pose, Echoes echoes) {
        double angle = Math.toRadians(pose.headingDeg());
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        double sum = 0;
        for (int index = 0; index < echoes.count(); index++) {
            double distance = field.distanceMm(
                    pose.xMm() + cos * echoes.x()[index] - sin * echoes.y()[index],
                    pose.yMm() + sin * echoes.x()[index] + cos * echoes.y()[index]);
            sum += Double.isNaN(distance)
                    ? NEUTRAL
                    : Math.log(RANDOM + (1 - RANDOM) * Math.exp(-distance * distance / (2 * SIGMA_MM * SIGMA_MM)));
        }
        return sum / echoes.count();
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
            double distance = field.distanceMm(
                    pose.xMm() + cos * echoes.x()[index] - sin * echoes.y()[index],
                    pose.yMm() + sin * echoes.x()[index] + cos * echoes.y()[index]);
            boolean unknown = Double.isNaN(distance)
                    && !isBehindWall(
                            pose,
                            Math.hypot(echoes.x()[index], echoes.y()[index]),
                            angle + Math.atan2(echoes.y()[index], echoes.x()[index]));
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

    private static double[] equal(int count) {
        double[] weights = new double[count];
        Arrays.fill(weights, 1.0 / count);
        return weights;
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

    /** Draws many poses and keeps those that the scan fits best (sensor resetting; Lenser and Veloso 2000). */
    private void spread(Echoes echoes) {
        List<Pose> drawn = new ArrayList<>(TRIALS);
        double[] likely = new double[TRIALS];
        double most = Double.NEGATIVE_INFINITY;
        for (int index = 0; index < TRIALS; index++) {
            drawn.add(anywhere());
            likely[index] = likelihood(drawn.get(index), echoes) * INDEPENDENT / 2;
            most = Math.max(most, likely[index]);
        }
        particles = drawn;
        weights = likely;
        normalise(most);
        draw(MOST, echoes, 0);
        summarise();
    }

    private void normalise(double most) {
        double sum = 0;
        for (int index = 0; index < weights.length; index++) {
            weights[index] = Math.exp(weights[index] - most);
            sum += weights[index];
        }
        for (int index = 0; index < weights.length; index++) {
            weights[index] /= sum;
        }
    }

    private void weigh(Echoes echoes) {
        weights = new double[particles.size()];
        double most = Double.NEGATIVE_INFINITY;
        double mean = 0;
        for (int index = 0; index < weights.length; index++) {
            double log = likelihood(particles.get(index), echoes);
            mean += Math.exp(log) / weights.length;
            weights[index] = log * (global ? INDEPENDENT / 2 : INDEPENDENT);
            most = Math.max(most, weights[index]);
        }
        slow += slow == 0 ? mean : SLOW * (mean - slow);
        fast += fast == 0 ? mean : FAST * (mean - fast);
        normalise(most);
    }

    private void resample(Echoes echoes) {
        double lost = global ? Math.max(0, 1 - fast / slow) : 0;
        draw(needed(), echoes, lost > 0.1 ? lost / 2 : 0);
    }

    /** The number of particles by KLD sampling, from the bins that have weight. */
    private int needed() {
        Map<Long, Double> bins = new HashMap<>();
        for (int index = 0; index < weights.length; index++) {
            bins.merge(bin(particles.get(index)), weights[index], Double::sum);
        }
        long filled = bins.values().stream().filter(weight -> weight > 1e-4).count();
        if (filled < 2) {
            return LEAST;
        }
        double k = filled - 1;
        double a = 2 / (9 * k);
        double needed = k / (2 * ERROR) * Math.pow(1 - a + Math.sqrt(a) * QUANTILE, 3);
        return (int) Math.max(LEAST, Math.min(MOST, needed));
    }

    private static long bin(Pose pose) {
        long x = (long) Math.floor(pose.xMm() / BIN_MM);
        long y = (long) Math.floor(pose.yMm() / BIN_MM);
        long t = (long) Math.floor((pose.headingDeg() + 180) / BIN_DEG);
        return (x * 1_000_003 + y) * 64 + t;
    }

    /**
     * Systematic resampling (low variance; Thrun, Burgard, Fox 2005, table 4.4), with a share of poses from anywhere.
     */
    private void draw(int count, Echoes echoes, double anywhere) {
        List<Pose> next = new ArrayList<>(count);
        double at = random.nextDouble() / count;
        double sum = weights[0];
        int index = 0;
        for (int number = 0; number < count; number++, at += 1.0 / count) {
            while (at > sum && index < weights.length - 1) {
                sum += weights[++index];
            }
            next.add(anywhere > 0 && random.nextDouble() < anywhere ? best(echoes) : particles.get(index));
        }
        particles = next;
        weights = equal(count);
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

    /** The mean and the covariance of the particles around the fullest bin. */
    private void summarise() {
        Map<Long, Integer> bins = new HashMap<>();
        Pose centre = particles.get(0);
        int most = 0;
        for (Pose particle : particles) {
            int count = bins.merge(bin(particle), 1, Integer::sum);
            if (count > most) {
                most = count;
                centre = particle;
            }
        }
        double x = 0;
        double y = 0;
        double turn = 0;
        List<Pose> group = new ArrayList<>();
        for (Pose particle : particles) {
            double turned = Pose.normalised(particle.headingDeg() - centre.headingDeg());
            if (particle.distanceMm(centre) < GROUP_MM && Math.abs(turned) < GROUP_DEG) {
                group.add(particle);
                x += particle.xMm();
                y += particle.yMm();
                turn += turned;
            }
        }
        int count = group.size();
        Pose mean = new Pose(x / count, y / count, centre.headingDeg() + turn / count);
        double xx = 0;
        double xy = 0;
        double yy = 0;
        double tt = 0;
        for (Pose particle : group) {
            double dx = particle.xMm() - mean.xMm();
            double dy = particle.yMm() - mean.yMm();
            xx += dx * dx / count;
            xy += dx * dy / count;
            yy += dy * dy / count;
            tt += Math.pow(Pose.normalised(particle.headingDeg() - mean.headingDeg()), 2) / count;
        }
        dominant = (double) count / particles.size();
        estimate = new PoseEstimate(mean, xx, xy, yy, Math.sqrt(tt), placed);
    }

    /** Decides whether the estimate may be relied on. */
    private void judge(Echoes echoes) {
        Fit now = fitAt(estimate.pose(), echoes);
        if (now.known() > LEAST_KNOWN) {
            fit += (fit == 0 ? 1 : FAST) * (now.near() - fit);
            boolean agrees = dominant > DOMINANT && estimate.sigmaMm() < MOST_SIGMA_MM && fit > LEAST_FIT;
            steady = agrees ? steady + 1 : 0;
            unfit = fit < (global ? LEAST_FIT : LOST_FIT) ? unfit + 1 : 0;
        }
        if (steady >= STEADY) {
            placed = true;
            global = false;
        }
        if (unfit >= STEADY) {
            search();
        }
        estimate = new PoseEstimate(
                estimate.pose(),
                estimate.varianceXmm2(),
                estimate.covarianceXYmm2(),
                estimate.varianceYmm2(),
                estimate.sigmaDeg(),
                placed);
    }
}
