package majic.nav.localisation;

import java.util.Random;
import majic.bot.Pose;

/**
 * The errors of wheel odometry, which grow with the way and the turn (Thrun, Burgard, Fox 2005, 5.4): for each metre a
 * standard deviation of 100 mm along and 50 mm across and of 3 degrees, for each turn one of 10 %. Errors of motions
 * that follow each other are independent, so variances grow in proportion.
 */
final class MotionModel {
    private static final double MM_PER_M = 100;
    private static final double DEG_PER_M = 3;
    private static final double SHARE_OF_TURN = 0.1;

    /** A turn of 360 degrees displaces the centre by some 50 mm. */
    private static final double MM_PER_TURN = 50;

    private static final double M = 1000;
    private static final double FULL_TURN = 360;

    /** The turn whose error is the share of it; a longer one is several of these. */
    private static final double ONE_TURN = 30;

    private MotionModel() {}

    static double varianceMm2(double wayMm, double turnDeg) {
        return MM_PER_M * MM_PER_M * wayMm / M + MM_PER_TURN * MM_PER_TURN * turnDeg / FULL_TURN;
    }

    static double varianceRad2(double wayMm, double turnDeg) {
        double deg2 = DEG_PER_M * DEG_PER_M * wayMm / M + Math.pow(SHARE_OF_TURN, 2) * ONE_TURN * turnDeg;
        return deg2 * Math.pow(Math.toRadians(1), 2);
    }

    /**
     * A motion as it may have been.
     *
     * @param share of the standard deviations of wheel odometry
     */
    static Pose sample(Pose step, double share, Random random) {
        double way = Math.hypot(step.xMm(), step.yMm());
        double turn = Math.abs(step.headingDeg());
        double sigma = share * Math.sqrt(varianceMm2(way, turn));
        return new Pose(
                step.xMm() + sigma * random.nextGaussian(),
                step.yMm() + sigma / 2 * random.nextGaussian(),
                step.headingDeg() + share * Math.toDegrees(Math.sqrt(varianceRad2(way, turn))) * random.nextGaussian());
    }
}
