package majicsim.aibo.urbi.assign;

/**
 * How a value goes to its target over time (URBI sheet, section 6).
 *
 * @param durationMs how long it takes; infinite for an oscillation
 * @param curve the value at a time in ms since its start
 * @param phase how far an oscillation is at that time, in rad from 0 to 2 pi; 0 for others
 */
record Trajectory(double durationMs, Curve curve, Curve phase) {
    /** A value over time. */
    interface Curve {
        double at(double elapsedMs);
    }

    /** From one value to another, or around it, by the modifiers. */
    static Trajectory of(double from, double to, Modifiers modifiers) {
        if (modifiers.oscillates()) {
            return oscillation(to, modifiers);
        }
        if (modifiers.has("smooth")) {
            double ms = modifiers.get("smooth", 0);
            return reaching(ms, t -> from + (to - from) * (1 - Math.cos(Math.PI * share(t, ms))) / 2);
        }
        if (modifiers.has("accel") && !modifiers.has("speed") && !modifiers.has("time")) {
            return accelerated(from, to, Math.abs(modifiers.get("accel", 0)));
        }
        double ms = durationMs(Math.abs(to - from), modifiers);
        return reaching(ms, t -> from + (to - from) * share(t, ms));
    }

    /** The same way at this many units a second. */
    static Trajectory paced(double from, double to, double unitsPerSec) {
        double ms = Math.abs(to - from) / unitsPerSec * 1000;
        return reaching(ms, t -> from + (to - from) * share(t, ms));
    }

    private static Trajectory reaching(double ms, Curve curve) {
        return new Trajectory(Math.max(0, ms), curve, t -> 0);
    }

    private static Trajectory accelerated(double from, double to, double unitsPerSec2) {
        double ms = unitsPerSec2 <= 0 ? 0 : Math.sqrt(2 * Math.abs(to - from) / unitsPerSec2) * 1000;
        return reaching(ms, t -> from + (to - from) * share(t, ms) * share(t, ms));
    }

    /** Beside a speed, an acceleration is taken and not used: on the real kernel it changed no duration (capture E). */
    private static double durationMs(double way, Modifiers modifiers) {
        double speed = Math.abs(modifiers.get("speed", 0));
        return speed > 0 ? way / speed * 1000 : Math.abs(modifiers.get("time", 0));
    }

    private static double share(double elapsedMs, double durationMs) {
        return durationMs <= 0 ? 1 : Math.max(0, Math.min(1, elapsedMs / durationMs));
    }

    private static Trajectory oscillation(double centre, Modifiers modifiers) {
        double quarter = modifiers.has("cos") ? Math.PI / 2 : 0;
        double periodMs = modifiers.get("sin", modifiers.get("cos", 1000));
        double amplitude = modifiers.get("ampli", 0);
        double start = modifiers.get("phase", 0) + quarter;
        double radPerMs = periodMs == 0 ? 0 : 2 * Math.PI / periodMs;
        return new Trajectory(
                Double.POSITIVE_INFINITY,
                t -> centre + amplitude * Math.sin(radPerMs * t + start),
                t -> turned(radPerMs * t + start));
    }

    private static double turned(double rad) {
        double rest = rad % (2 * Math.PI);
        return rest < 0 ? rest + 2 * Math.PI : rest;
    }
}
