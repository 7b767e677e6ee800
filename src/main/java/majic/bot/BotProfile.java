package majic.bot;

/**
 * The size and the speeds of one type or model of robot. Immutable.
 *
 * @param bodyMm radius of a circle it fits in, around its turning centre
 * @param speed the speeds it can go, mm/s, both signs
 * @param turn the rates it can turn at, deg/s, both signs
 * @param slowestMmPerSec the least that {@code cruise} may be set to
 * @param slowestTurnDegPerSec the least that {@code cruiseTurn} may be set to
 * @param cruiseMmPerSec how fast {@code move} goes unless set otherwise: a conservative value
 * @param cruiseTurnDegPerSec how fast {@code turn} goes unless set otherwise
 * @param nearMm the distance below which something counts as near
 * @param estimates whether its pose is only dead reckoning from the commands sent, because it has no odometry
 * @param leavesGround whether it flies or dives: an act that is not for such robots must not move it
 */
public record BotProfile(
        double bodyMm,
        Range speed,
        Range turn,
        double slowestMmPerSec,
        double slowestTurnDegPerSec,
        double cruiseMmPerSec,
        double cruiseTurnDegPerSec,
        double nearMm,
        boolean estimates,
        boolean leavesGround) {
    private static final double CRAWL = 1;

    /** Wheels or legs of both sides differ by some 4 % in their speeds, where nothing measures that. */
    private static final double MISMATCH = 0.04;

    /** The distance of both sides, in radii of the body. */
    private static final double TRACK = 1.6;

    private static final double M = 1000;

    /**
     * Creates a profile of a robot that stays on the ground.
     *
     * @param bodyMm as of the record
     * @param speed as of the record
     * @param turn as of the record
     * @param slowestMmPerSec as of the record
     * @param slowestTurnDegPerSec as of the record
     * @param cruiseMmPerSec as of the record
     * @param cruiseTurnDegPerSec as of the record
     * @param nearMm as of the record
     * @param estimates as of the record
     */
    public BotProfile(
            double bodyMm,
            Range speed,
            Range turn,
            double slowestMmPerSec,
            double slowestTurnDegPerSec,
            double cruiseMmPerSec,
            double cruiseTurnDegPerSec,
            double nearMm,
            boolean estimates) {
        this(
                bodyMm,
                speed,
                turn,
                slowestMmPerSec,
                slowestTurnDegPerSec,
                cruiseMmPerSec,
                cruiseTurnDegPerSec,
                nearMm,
                estimates,
                false);
    }

    /**
     * Creates a profile of a robot without a lowest speed.
     *
     * @param bodyMm radius of a circle it fits in
     * @param speed the speeds it can go, mm/s
     * @param turn the rates it can turn at, deg/s
     * @param cruiseMmPerSec how fast {@code move} goes unless set otherwise
     * @param cruiseTurnDegPerSec how fast {@code turn} goes unless set otherwise
     * @param nearMm the distance below which something counts as near
     * @param estimates whether its pose is only dead reckoning
     */
    public BotProfile(
            double bodyMm,
            Range speed,
            Range turn,
            double cruiseMmPerSec,
            double cruiseTurnDegPerSec,
            double nearMm,
            boolean estimates) {
        this(bodyMm, speed, turn, CRAWL, CRAWL, cruiseMmPerSec, cruiseTurnDegPerSec, nearMm, estimates);
    }

    /**
     * Returns how much the robot veers from the heading that it reports.
     *
     * @return the standard deviation after one metre, deg: more if the pose is estimated, and the smaller the robot is
     */
    public double veerDegPerM() {
        return estimates
                ? Math.max(Uncertainty.DEG_PER_M, Math.toDegrees(MISMATCH * M / (TRACK * bodyMm)))
                : Uncertainty.DEG_PER_M;
    }
}
