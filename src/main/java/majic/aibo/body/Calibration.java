package majic.aibo.body;

import java.util.Locale;
import java.util.Optional;
import majic.bot.BotException;
import majic.bot.Range;
import majic.environment.Settings;

/**
 * The time that one dog takes for a millimetre or a degree at the usual pace of its legs. Stored in the user's settings
 * under {@code aibo.HOST.forward}, {@code .backward} (ms per mm), {@code .left}, {@code .right} (ms per degree).
 */
public final class Calibration {
    /** A factor may differ from the usual one by this factor; others are taken for typing errors. */
    private static final double MOST_TIMES_USUAL = 4;

    private final Settings settings;
    private final String keyStem;

    public Calibration(Settings settings, String host) {
        this.settings = settings;
        this.keyStem = "aibo." + host + ".";
    }

    /** Milliseconds for one mm or one degree of a gait at the usual pace. */
    public double msPerUnit(Gait gait) {
        return settings.get(keyStem + gait.key())
                .flatMap(text -> plausible(text, gait))
                .orElse(gait.usualMsPerUnit());
    }

    /** The valid range of a factor. */
    public static Range range(Gait gait) {
        return new Range(gait.usualMsPerUnit() / MOST_TIMES_USUAL, gait.usualMsPerUnit() * MOST_TIMES_USUAL);
    }

    /**
     * Stores a factor.
     *
     * @throws BotException if it could not be stored for the next start
     */
    public void keep(Gait gait, double msPerUnit) {
        settings.put(keyStem + gait.key(), String.format(Locale.ROOT, "%.3f", msPerUnit));
    }

    /** A gait at the usual pace of the legs. */
    public Stride stride(Gait gait) {
        return stride(gait, Stride.USUAL_CYCLE_MS);
    }

    /** A gait at a speed in mm/s or deg/s, positive, or as near to it as the dog's legs can do. */
    public Stride strideAt(Gait gait, double unitsPerSecond) {
        double cycleMs = Stride.USUAL_CYCLE_MS * stride(gait).unitsPerSecond() / unitsPerSecond;
        Range possible = new Range(Stride.FASTEST_CYCLE_MS, Stride.SLOWEST_CYCLE_MS);
        return stride(gait, (int) Math.round(possible.clamp(cycleMs)));
    }

    /** A gait at the highest pace at which the feet do not slip. */
    Stride fastest(Gait gait) {
        return stride(gait, Stride.FASTEST_CYCLE_MS);
    }

    /** A gait at the lowest useful pace. */
    Stride slowest(Gait gait) {
        return stride(gait, Stride.SLOWEST_CYCLE_MS);
    }

    /** The speed scales with the pace of the legs until the feet slip (URBI sheet 15, "Calibration"). */
    private Stride stride(Gait gait, int cycleMs) {
        return new Stride(gait, cycleMs, msPerUnit(gait) * cycleMs / Stride.USUAL_CYCLE_MS);
    }

    private static Optional<Double> plausible(String text, Gait gait) {
        try {
            double msPerUnit = Double.parseDouble(text);
            return range(gait).contains(msPerUnit) ? Optional.of(msPerUnit) : Optional.empty();
        } catch (NumberFormatException e) {
            return Optional.empty();
        }
    }
}
