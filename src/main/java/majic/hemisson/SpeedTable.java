package majic.hemisson;

/**
 * How fast a wheel runs for each motor value, and how far apart the wheels are, for one robot. Nothing on the robot
 * measures it, so it can only be calibrated by a person. Immutable.
 *
 * @param scale this robot's speeds as a multiple of the manual's curve (Hemisson sheet 5)
 * @param wheelDistanceMm from wheel to wheel, mm
 */
record SpeedTable(double scale, double wheelDistanceMm) {
    /** The sheet's credible value; makers of other clients used 110 and 112. */
    static final double USUAL_WHEEL_DISTANCE_MM = 90;

    /** The slowest value that reliably overcomes friction. */
    static final int SLOWEST = 2;

    private static final double[] MM_PER_SEC = {0, 3, 18, 42, 64, 86, 109, 134, 156, 184};

    static final SpeedTable USUAL = new SpeedTable(1, USUAL_WHEEL_DISTANCE_MM);

    SpeedTable {
        if (!(scale > 0) || !(wheelDistanceMm > 0)) {
            throw new IllegalArgumentException("not a calibration: " + scale + ", " + wheelDistanceMm);
        }
    }

    /** The speed of a wheel, mm/s, for a motor value of -9 to 9. */
    double mmPerSec(int value) {
        return Math.signum(value) * MM_PER_SEC[Math.abs(value)] * scale;
    }

    /** The highest speed of a wheel, mm/s. */
    double fastestMmPerSec() {
        return mmPerSec(Wheels.MAX);
    }

    /** The rate at which it spins with both wheels at a value, deg/s. */
    double spinDegPerSec(int value) {
        return Math.toDegrees(2 * mmPerSec(value) / wheelDistanceMm);
    }

    /** The value that comes nearest to a wheel speed; 0 or one that turns the wheel. */
    int nearest(double wantedMmPerSec) {
        int best = 0;
        for (int value = SLOWEST; value <= Wheels.MAX; value++) {
            if (Math.abs(mmPerSec(value) - Math.abs(wantedMmPerSec))
                    < Math.abs(mmPerSec(best) - Math.abs(wantedMmPerSec))) {
                best = value;
            }
        }
        return wantedMmPerSec < 0 ? -best : best;
    }

    /** The nearest wheel values for a curve; one too fast is slowed down without bending it otherwise. */
    Wheels curve(double speedMmPerSec, double turnDegPerSec) {
        double half = Math.toRadians(turnDegPerSec) * wheelDistanceMm / 2;
        double left = speedMmPerSec - half;
        double right = speedMmPerSec + half;
        double slower = Math.min(1, fastestMmPerSec() / Math.max(1, Math.max(Math.abs(left), Math.abs(right))));
        return new Wheels(nearest(left * slower), nearest(right * slower));
    }

    /** The path speed for wheel values, mm/s, ahead positive. */
    double speedMmPerSec(Wheels wheels) {
        return (mmPerSec(wheels.left()) + mmPerSec(wheels.right())) / 2;
    }

    /** The turn rate for wheel values, deg/s, left positive. */
    double turnDegPerSec(Wheels wheels) {
        return Math.toDegrees((mmPerSec(wheels.right()) - mmPerSec(wheels.left())) / wheelDistanceMm);
    }
}
