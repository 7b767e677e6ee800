package majicsim.aibo.urbi.assign;

import majicsim.aibo.urbi.run.Server;

/**
 * An assignment that is planned anew each cycle from the joint's measured position, {@code adaptive:1} (URBI sheet,
 * section 6).
 */
final class AdaptiveMotion {
    private final double target;
    private final Modifiers modifiers;

    AdaptiveMotion(double target, Modifiers modifiers) {
        this.target = target;
        this.modifiers = modifiers;
    }

    /** Whether a position is within {@code delta} of the target, in the variable's units. */
    boolean isThere(double now, double delta) {
        return Math.abs(now - target) <= delta;
    }

    /** The command for this cycle, at a time in ms after the start. */
    double next(double now, double elapsedMs) {
        double way = Math.abs(target - now);
        double stride = Math.min(way, stride(way, elapsedMs));
        return now + Math.signum(target - now) * stride;
    }

    private double stride(double way, double elapsedMs) {
        if (modifiers.has("time")) {
            double leftMs = Math.abs(modifiers.get("time", 0)) - elapsedMs;
            return leftMs <= Server.CYCLE_MS ? way : way * Server.CYCLE_MS / leftMs;
        }
        return Math.abs(modifiers.get("speed", 0)) * Server.CYCLE_MS / 1000;
    }
}
