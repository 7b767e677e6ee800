package majic.aibo;

import java.util.Optional;
import majic.bot.Settings;

/**
 * How long this very dog takes for a millimetre or a degree. Kept in the user's settings under {@code
 * aibo.HOST.forward}, {@code .backward} (ms per mm), {@code .left}, {@code .right} (ms per degree).
 */
final class Calibration {
    /** What a factor may be, times the usual one; anything else is a slip of the pen. */
    private static final double MOST_TIMES_USUAL = 10;

    private final Settings settings;
    private final String keyStem;

    Calibration(Settings settings, String host) {
        this.settings = settings;
        this.keyStem = "aibo." + host + ".";
    }

    /** Milliseconds for one mm or one degree of a gait. */
    double msPerUnit(Gait gait) {
        return settings.get(keyStem + gait.key())
                .flatMap(text -> plausible(text, gait))
                .orElse(gait.usualMsPerUnit());
    }

    /** How fast a gait goes, mm/s or deg/s, always positive. */
    double unitsPerSecond(Gait gait) {
        return 1000 / msPerUnit(gait);
    }

    private static Optional<Double> plausible(String text, Gait gait) {
        try {
            double ratio = Double.parseDouble(text) / gait.usualMsPerUnit();
            boolean fits = ratio >= 1 / MOST_TIMES_USUAL && ratio <= MOST_TIMES_USUAL;
            return fits ? Optional.of(Double.parseDouble(text)) : Optional.empty();
        } catch (NumberFormatException e) {
            return Optional.empty();
        }
    }
}
