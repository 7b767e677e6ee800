package majicsim.aibo.urbi.assign;

import majicsim.aibo.urbi.run.Server;

/** An assignment that is planned anew each cycle from where the joint really is, {@code adaptive:1} (URBI sheet, section 6). */
final class Pursuit {
    private final double target;
    private final Modifiers modifiers;

    Pursuit(double target, Modifiers modifiers) {
        this.target = target;
        this.modifiers = modifiers;
    }

    /** Whether this is near enough to the target, with the variable's own {@code delta} in its units. */
    boolean isThere(double now, double delta) {
        return Math.abs(now - target) <= delta;
    }

    /** What to command in this cycle, so many ms after the start. */
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
