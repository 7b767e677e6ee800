package majic.bot;

/**
 * What makes one type or model of robot different in size and pace. Immutable.
 *
 * @param bodyMm radius of a circle it fits in, around its turning centre
 * @param speed the speeds it can go, mm/s, both signs
 * @param turn the rates it can turn at, deg/s, both signs
 * @param cruiseMmPerSec how fast {@code move} goes unless told otherwise: a careful choice
 * @param cruiseTurnDegPerSec how fast {@code turn} goes unless told otherwise
 * @param nearMm what counts as close for it
 * @param estimates whether its pose is only dead reckoning from what it was told, for want of odometry
 */
public record BotProfile(
        double bodyMm,
        Range speed,
        Range turn,
        double cruiseMmPerSec,
        double cruiseTurnDegPerSec,
        double nearMm,
        boolean estimates) {}
