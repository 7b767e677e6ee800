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
        boolean estimates) {
    private static final double CRAWL = 1;

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
}
