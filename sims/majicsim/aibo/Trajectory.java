package majicsim.aibo;

import java.util.Map;
import java.util.Set;

/**
 * How a value goes to its target over time (URBI sheet, section 6).
 *
 * @param durationMs how long it takes; infinite for an oscillation
 * @param curve the value at a time in ms since its start
 */
record Trajectory(double durationMs, Curve curve) {
    private static final Set<String> KNOWN = Set.of(
            "time", "speed", "accel", "smooth", "sin", "cos", "ampli", "phase", "getphase", "adaptive", "timelimit");

    /** A value over time. */
    interface Curve {
        double at(double elapsedMs);
    }

    /** Refuses a modifier that does not exist. */
    static void check(String modifier) throws Failure {
        if (!KNOWN.contains(modifier)) {
            throw Failure.of("Unkown modificator name");
        }
    }

    /** From one value to another, or around it, as the modifiers say. */
    static Trajectory of(double from, double to, Map<String, Double> modifiers) {
        if (modifiers.containsKey("sin") || modifiers.containsKey("cos")) {
            return oscillation(to, modifiers);
        }
        if (modifiers.containsKey("smooth")) {
            double ms = modifiers.getOrDefault("smooth", 0.0);
            return reaching(ms, t -> from + (to - from) * (1 - Math.cos(Math.PI * share(t, ms))) / 2);
        }
        double ms = durationMs(Math.abs(to - from), modifiers);
        return reaching(ms, t -> from + (to - from) * share(t, ms));
    }

    /** The same way, but never faster than this many units a second. */
    static Trajectory limited(double from, double to, double unitsPerSec) {
        double ms = Math.abs(to - from) / unitsPerSec * 1000;
        return reaching(ms, t -> from + (to - from) * share(t, ms));
    }

    private static Trajectory reaching(double ms, Curve curve) {
        return new Trajectory(Math.max(0, ms), curve);
    }

    /** An acceleration is taken and not used: on the real kernel it changed no duration (capture E). */
    private static double durationMs(double way, Map<String, Double> modifiers) {
        double speed = Math.abs(modifiers.getOrDefault("speed", 0.0));
        if (speed > 0) {
            return way / speed * 1000;
        }
        return modifiers.getOrDefault("time", modifiers.getOrDefault("adaptive", 0.0));
    }

    private static double share(double elapsedMs, double durationMs) {
        return durationMs <= 0 ? 1 : Math.max(0, Math.min(1, elapsedMs / durationMs));
    }

    private static Trajectory oscillation(double centre, Map<String, Double> modifiers) {
        double quarter = modifiers.containsKey("cos") ? Math.PI / 2 : 0;
        double periodMs = modifiers.getOrDefault("sin", modifiers.getOrDefault("cos", 1000.0));
        double amplitude = modifiers.getOrDefault("ampli", 0.0);
        double phase = modifiers.getOrDefault("phase", 0.0) + quarter;
        double radPerMs = periodMs == 0 ? 0 : 2 * Math.PI / periodMs;
        return new Trajectory(Double.POSITIVE_INFINITY, t -> centre + amplitude * Math.sin(radPerMs * t + phase));
    }
}
