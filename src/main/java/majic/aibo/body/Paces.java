package majic.aibo.body;

import majic.bot.BotProfile;
import majic.bot.Range;

/** What a dog's calibration makes of its size and pace, and of the speed that was set. Immutable. */
public final class Paces {
    /** Half of 319 × 180 mm around the turning centre, with the corners. */
    private static final double BODY_MM = 183;

    private static final double NEAR_MM = 250;

    private final Calibration calibration;

    public Paces(Calibration calibration) {
        this.calibration = calibration;
    }

    public BotProfile profile() {
        return new BotProfile(
                BODY_MM,
                bothWays(Gait.FORWARD, Gait.BACKWARD),
                bothWays(Gait.LEFT, Gait.RIGHT),
                calibration.slowest(Gait.FORWARD).unitsPerSecond(),
                calibration.slowest(Gait.LEFT).unitsPerSecond(),
                calibration.stride(Gait.FORWARD).unitsPerSecond(),
                calibration.stride(Gait.LEFT).unitsPerSecond(),
                NEAR_MM,
                true);
    }

    private Range bothWays(Gait one, Gait other) {
        double fastest = Math.max(
                calibration.fastest(one).unitsPerSecond(),
                calibration.fastest(other).unitsPerSecond());
        return new Range(-fastest, fastest);
    }

    /**
     * A gait at the legs' usual pace, unless a speed was set.
     *
     * @param wished what was set, mm/s or deg/s
     * @param usual the value of the setting while none was set
     */
    public Stride stride(Gait gait, double wished, double usual) {
        return wished == usual ? calibration.stride(gait) : calibration.strideAt(gait, wished);
    }
}
