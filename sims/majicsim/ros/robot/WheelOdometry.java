package majicsim.ros.robot;

/** Dead reckoning from the wheels: metres and radians from the place where the robot was switched on. */
final class WheelOdometry {
    private static final double WHEEL_RADIUS_M = 0.033;

    private double x;
    private double y;
    private double yaw;
    private double leftMetres;
    private double rightMetres;
    private double leftMetresPerSec;
    private double rightMetresPerSec;

    void step(double left, double right, double seconds) {
        leftMetresPerSec = left;
        rightMetresPerSec = right;
        leftMetres += left * seconds;
        rightMetres += right * seconds;
        double ahead = metresPerSec() * seconds;
        double turned = radPerSec() * seconds;
        double chord = Math.abs(turned) < 1e-9 ? ahead : ahead * Math.sin(turned / 2) / (turned / 2);
        x += chord * Math.cos(yaw + turned / 2);
        y += chord * Math.sin(yaw + turned / 2);
        yaw = Math.IEEEremainder(yaw + turned, 2 * Math.PI);
    }

    double x() {
        return x;
    }

    double y() {
        return y;
    }

    /** Counter-clockwise, -π to π. */
    double yaw() {
        return yaw;
    }

    double metresPerSec() {
        return (leftMetresPerSec + rightMetresPerSec) / 2;
    }

    double radPerSec() {
        return (rightMetresPerSec - leftMetresPerSec) / (2 * BurgerDrive.HALF_TRACK_M);
    }

    /** How far the left wheel has turned, rad. */
    double leftAngle() {
        return leftMetres / WHEEL_RADIUS_M;
    }

    double rightAngle() {
        return rightMetres / WHEEL_RADIUS_M;
    }

    double leftRadPerSec() {
        return leftMetresPerSec / WHEEL_RADIUS_M;
    }

    double rightRadPerSec() {
        return rightMetresPerSec / WHEEL_RADIUS_M;
    }
}
