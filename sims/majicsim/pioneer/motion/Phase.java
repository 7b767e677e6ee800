package majicsim.pioneer.motion;

/**
 * A phase of motion with constant acceleration. The linear ramps of the controller (ARCOS sheet 7.2) are chains of such
 * phases, which makes them exact for any length of a step.
 *
 * @param acceleration signed
 * @param seconds how long it lasts, infinite when nothing ends it
 * @param end where it ends, free of rounding; meaningless when it never does
 */
record Phase(double acceleration, double seconds, Travel end) {
    /** Below this a distance in mm or degrees, or a speed, is rounding. */
    private static final double NOTHING = 1e-9;

    /** The next phase from here to this speed, through rest if the direction changes. */
    static Phase toSpeed(Travel from, double wanted, Limits limits) {
        double speed = from.speed();
        if (speed == wanted) {
            return steady(from);
        }
        if (speed * wanted < 0) {
            return ramp(from, 0, limits.deceleration());
        }
        boolean faster = Math.abs(wanted) > Math.abs(speed);
        return ramp(from, wanted, faster ? limits.acceleration() : limits.deceleration());
    }

    /** The next phase from here to rest at this position: speed up, hold, brake so that it ends there. */
    static Phase toPosition(Travel from, double target, Limits limits) {
        double way = target - from.position();
        if (Math.abs(way) < NOTHING && Math.abs(from.speed()) < NOTHING) {
            return steady(new Travel(target, 0));
        }
        double direction = way == 0 ? Math.signum(from.speed()) : Math.signum(way);
        double approach = from.speed() * direction;
        double brakingWay = approach * approach / (2 * limits.deceleration());
        boolean comesPast = brakingWay > Math.abs(way) * (1 + 1e-6) + NOTHING;
        if (approach < 0 || comesPast) {
            return ramp(from, 0, limits.deceleration());
        }
        if (brakingWay > Math.abs(way) * (1 - NOTHING) - NOTHING) {
            return landing(from, target);
        }
        return approaching(from, way, limits);
    }

    /** A phase before the point where braking must begin. */
    private static Phase approaching(Travel from, double way, Limits limits) {
        double distance = Math.abs(way);
        double approach = Math.abs(from.speed());
        double peak = Math.min(limits.speedTowards(way), peak(approach, distance, limits));
        if (approach > peak) {
            return ramp(from, Math.copySign(peak, way), limits.deceleration());
        }
        if (peak > approach * (1 + NOTHING)) {
            return ramp(from, Math.copySign(peak, way), limits.acceleration());
        }
        double seconds = (distance - approach * approach / (2 * limits.deceleration())) / approach;
        return new Phase(0, seconds, from.after(seconds, 0));
    }

    /** The speed at which acceleration must change to braking, without a speed limit. */
    private static double peak(double approach, double distance, Limits limits) {
        double square = (2 * distance + approach * approach / limits.acceleration())
                / (1 / limits.acceleration() + 1 / limits.deceleration());
        return Math.sqrt(square);
    }

    /** Brakes so that it ends at the target, nearly with the set deceleration. */
    private static Phase landing(Travel from, double target) {
        double way = target - from.position();
        if (Math.abs(way) < NOTHING) {
            return new Phase(0, 0, new Travel(target, 0));
        }
        return new Phase(-from.speed() * from.speed() / (2 * way), 2 * way / from.speed(), new Travel(target, 0));
    }

    private static Phase ramp(Travel from, double speed, double rate) {
        double change = speed - from.speed();
        double acceleration = Math.copySign(rate, change);
        double seconds = Math.abs(change) / rate;
        return new Phase(
                acceleration, seconds, from.after(seconds, acceleration).withSpeed(speed));
    }

    private static Phase steady(Travel from) {
        return new Phase(0, Double.POSITIVE_INFINITY, from);
    }
}
