package majicsim.pioneer.devices;

/**
 * One motor of the gripper with an end stop on either side: 0 and 1. Runs at one speed until commanded otherwise or at
 * its end.
 */
final class Axis {
    private final double fullTravelSeconds;
    private double position;
    private double direction;
    private double leftSeconds;

    Axis(double fullTravelSeconds, double position) {
        this.fullTravelSeconds = fullTravelSeconds;
        this.position = position;
    }

    void up() {
        run(1, Double.POSITIVE_INFINITY);
    }

    void down() {
        run(-1, Double.POSITIVE_INFINITY);
    }

    /** Runs for this time, downwards if negative. */
    void run(double seconds) {
        run(Math.signum(seconds), Math.abs(seconds));
    }

    void stop() {
        direction = 0;
    }

    /** Lets it run, no lower than {@code lowest}. */
    void step(double seconds, double lowest) {
        if (direction == 0) {
            position = Math.max(lowest, position);
            return;
        }
        double running = Math.min(seconds, leftSeconds);
        leftSeconds -= running;
        position = Math.max(lowest, Math.min(1, position + direction * running / fullTravelSeconds));
        if (leftSeconds <= 0 || isAtEnd(lowest)) {
            stop();
        }
    }

    boolean isMoving() {
        return direction != 0;
    }

    double position() {
        return position;
    }

    private boolean isAtEnd(double lowest) {
        return direction > 0 && position >= 1 || direction < 0 && position <= lowest;
    }

    private void run(double newDirection, double seconds) {
        direction = newDirection;
        leftSeconds = seconds;
    }
}
