package majicsim.mavlink;

import majicsim.world.Body;

/** The wheels of a rover, left and right: they reach a wanted speed and turn rate with limited acceleration. */
final class SkidDrive {
    private static final double MM = 1000;

    private final Body body;
    private double speed;
    private double turnRate;

    SkidDrive(Body body) {
        this.body = body;
    }

    /**
     * Drives for a step.
     *
     * @param wish what is wanted
     * @param turnAcceleration rad/s²
     */
    void step(Wish wish, double turnAcceleration, double seconds) {
        speed = towards(speed, wish.speed(), wish.acceleration() * seconds);
        turnRate = towards(turnRate, wish.turnRate(), turnAcceleration * seconds);
        body.velocity(speed * MM, -Math.toDegrees(turnRate));
    }

    private static double towards(double from, double to, double most) {
        return from + Math.max(-most, Math.min(most, to - from));
    }

    /** The speed of the wheels, m/s ahead. */
    double speed() {
        return speed;
    }

    boolean isResting() {
        return speed == 0 && turnRate == 0;
    }

    /**
     * How to drive.
     *
     * @param speed m/s, negative backward
     * @param turnRate rad/s clockwise
     * @param acceleration how fast the speed may change, m/s²
     */
    record Wish(double speed, double turnRate, double acceleration) {}
}
