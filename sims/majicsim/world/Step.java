package majicsim.world;

/** A piece of motion: an arc's length and the turn on it. */
record Step(double mm, double deg) {
    static final Step NONE = new Step(0, 0);

    Step plus(Step other) {
        return new Step(mm + other.mm, deg + other.deg);
    }

    Step half() {
        return new Step(mm / 2, deg / 2);
    }

    boolean isNone() {
        return mm == 0 && deg == 0;
    }

    boolean isAbout(double path, double turn) {
        return Math.abs(mm - path) < 1e-6 && Math.abs(deg - turn) < 1e-6;
    }

    /** The farthest that a point at this distance from the turning centre moves on it. */
    double travelMm(double reachMm) {
        return Math.abs(mm) + Math.abs(Math.toRadians(deg)) * reachMm;
    }
}
