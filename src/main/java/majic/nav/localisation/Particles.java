package majic.nav.localisation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import majic.bot.Pose;
import majic.bot.Uncertainty;

/**
 * Poses that a robot may have, with weights: as many as the uncertainty needs (KLD sampling; Fox 2003). Not
 * thread-safe.
 */
final class Particles {
    private static final int LEAST = 500;
    private static final int MOST = 20_000;

    /** KLD sampling: error 0.05 with probability 0.99 in bins of 0.5 m and 10 degrees (Fox 2003, section 4). */
    private static final double BIN_MM = 500;

    private static final double BIN_DEG = 10;
    private static final double ERROR = 0.05;
    private static final double QUANTILE = 2.33;

    /** The group around the fullest bin: all particles within this. */
    private static final double GROUP_MM = 1000;

    private static final double GROUP_DEG = 30;

    private final Random random;
    private List<Pose> poses = new ArrayList<>();
    private double[] weights = {};

    Particles(Random random) {
        this.random = random;
    }

    /**
     * The poses around the most likely one.
     *
     * @param mean their mean
     * @param uncertainty their covariance
     * @param share of all particles
     */
    record Group(Pose mean, Uncertainty uncertainty, double share) {}

    int count() {
        return poses.size();
    }

    void clear() {
        poses = new ArrayList<>();
        weights = new double[0];
    }

    /** Scatters them around a pose. */
    void scatter(Pose around, double sigmaMm, double sigmaDeg) {
        poses = new ArrayList<>();
        for (int index = 0; index < LEAST; index++) {
            poses.add(new Pose(
                    around.xMm() + sigmaMm * random.nextGaussian(),
                    around.yMm() + sigmaMm * random.nextGaussian(),
                    around.headingDeg() + sigmaDeg * random.nextGaussian()));
        }
        weights = equal(poses.size());
    }

    /** Takes many poses, of which {@link #resample} keeps those that have weight. */
    void take(List<Pose> drawn) {
        poses = drawn;
        weights = equal(poses.size());
    }

    private static double[] equal(int count) {
        double[] weights = new double[count];
        Arrays.fill(weights, 1.0 / count);
        return weights;
    }

    /**
     * Moves each as the robot may have moved.
     *
     * @param share of the standard deviations of wheel odometry
     */
    void move(Pose step, double share) {
        double way = Math.hypot(step.xMm(), step.yMm());
        double turn = Math.abs(step.headingDeg());
        double sigmaMm = share * Math.sqrt(Uncertainty.ofWay(way, turn));
        double sigmaDeg = share * Math.toDegrees(Math.sqrt(Uncertainty.ofTurn(way, turn)));
        poses.replaceAll(pose -> pose.plus(new Pose(
                step.xMm() + sigmaMm * random.nextGaussian(),
                step.yMm() + sigmaMm / 2 * random.nextGaussian(),
                step.headingDeg() + sigmaDeg * random.nextGaussian())));
    }

    /**
     * Weighs each.
     *
     * @param likelihood the logarithm of the likelihood of an echo at a pose, in the mean of a scan
     * @param independent as how many independent echoes a scan counts
     * @return the mean likelihood of an echo
     */
    double weigh(ToDoubleFunction<Pose> likelihood, double independent) {
        weights = new double[poses.size()];
        double most = Double.NEGATIVE_INFINITY;
        double mean = 0;
        for (int index = 0; index < weights.length; index++) {
            double log = likelihood.applyAsDouble(poses.get(index));
            mean += Math.exp(log) / weights.length;
            weights[index] = log * independent;
            most = Math.max(most, weights[index]);
        }
        double sum = 0;
        for (int index = 0; index < weights.length; index++) {
            weights[index] = Math.exp(weights[index] - most);
            sum += weights[index];
        }
        for (int index = 0; index < weights.length; index++) {
            weights[index] /= sum;
        }
        return mean;
    }

    /** Draws as many as the bins that have weight need. */
    void resample(double share, Supplier<Pose> others) {
        draw(needed(), share, others);
    }

    /** Draws the most there may be. */
    void resampleMost() {
        draw(MOST, 0, () -> Pose.START);
    }

    private int needed() {
        Map<Long, Double> bins = new HashMap<>();
        for (int index = 0; index < weights.length; index++) {
            bins.merge(bin(poses.get(index)), weights[index], Double::sum);
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

    /** The bin of a pose. */
    static long bin(Pose pose) {
        long x = (long) Math.floor(pose.xMm() / BIN_MM);
        long y = (long) Math.floor(pose.yMm() / BIN_MM);
        long t = (long) Math.floor((pose.headingDeg() + 180) / BIN_DEG);
        return (x * 1_000_003 + y) * 64 + t;
    }

    /** Systematic resampling (low variance; Thrun, Burgard, Fox 2005, table 4.4), a share of them from elsewhere. */
    private void draw(int count, double share, Supplier<Pose> others) {
        List<Pose> next = new ArrayList<>(count);
        double at = random.nextDouble() / count;
        double sum = weights[0];
        int index = 0;
        for (int number = 0; number < count; number++, at += 1.0 / count) {
            while (at > sum && index < weights.length - 1) {
                sum += weights[++index];
            }
            next.add(share > 0 && random.nextDouble() < share ? others.get() : poses.get(index));
        }
        poses = next;
        weights = equal(count);
    }

    /** Returns the particles around the fullest bin. */
    Group group() {
        Map<Long, Integer> bins = new HashMap<>();
        Pose centre = poses.get(0);
        int most = 0;
        for (Pose pose : poses) {
            int count = bins.merge(bin(pose), 1, Integer::sum);
            if (count > most) {
                most = count;
                centre = pose;
            }
        }
        double x = 0;
        double y = 0;
        double turn = 0;
        List<Pose> group = new ArrayList<>();
        for (Pose pose : poses) {
            double turned = Pose.normalised(pose.headingDeg() - centre.headingDeg());
            if (pose.distanceMm(centre) < GROUP_MM && Math.abs(turned) < GROUP_DEG) {
                group.add(pose);
                x += pose.xMm();
                y += pose.yMm();
                turn += turned;
            }
        }
        int count = group.size();
        Pose mean = new Pose(x / count, y / count, centre.headingDeg() + turn / count);
        return new Group(mean, covariance(group, mean), (double) count / poses.size());
    }

    private static Uncertainty covariance(List<Pose> group, Pose mean) {
        double xx = 0;
        double xy = 0;
        double yy = 0;
        double xt = 0;
        double yt = 0;
        double tt = 0;
        double each = 1.0 / group.size();
        for (Pose pose : group) {
            double dx = pose.xMm() - mean.xMm();
            double dy = pose.yMm() - mean.yMm();
            double dt = Math.toRadians(Pose.normalised(pose.headingDeg() - mean.headingDeg()));
            xx += dx * dx * each;
            xy += dx * dy * each;
            yy += dy * dy * each;
            xt += dx * dt * each;
            yt += dy * dt * each;
            tt += dt * dt * each;
        }
        return new Uncertainty(xx, xy, yy, xt, yt, tt);
    }
}
