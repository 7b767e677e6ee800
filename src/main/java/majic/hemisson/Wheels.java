package majic.hemisson;

/**
 * What the two motors are told, each -9 to 9, ahead positive. Immutable; values beyond are clamped, since the robot
 * silently misreads them (Hemisson sheet 4.3).
 *
 * @param left the left motor
 * @param right the right motor
 */
record Wheels(int left, int right) {
    static final int MAX = 9;
    static final Wheels STILL = new Wheels(0, 0);

    Wheels {
        left = Math.max(-MAX, Math.min(MAX, left));
        right = Math.max(-MAX, Math.min(MAX, right));
    }

    /** What the robot says its motors are set to. */
    static Wheels of(Reply speeds) {
        return new Wheels(speeds.numbers().get(0), speeds.numbers().get(1));
    }

    boolean isStill() {
        return left == 0 && right == 0;
    }
}
