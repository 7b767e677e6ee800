package majicsim.mavlink;

import majicsim.mavlink.SkidDrive.Wish;
import org.jspecify.annotations.Nullable;

/**
 * How a rover follows its target: a place to reach or to keep, which holds until another target comes, or a speed with
 * a heading or a turn rate, which ends 3 s after it was last given (sheet 7, 9 and 12). Places are in m from the
 * origin.
 */
final class RoverGuidance {
    /** How fast it slows down when it just stops, m/s². */
    static final double BRAKING = 2;

    private static final double TIMEOUT_S = 3;
    private static final double APPROACH = 0.45;
    private static final double NEAR_M = 0.1;
    private static final double PASSED_M = 0.4;
    private static final double AIMED_RAD = Math.toRadians(10);
    private static final double LEAST_SHARE = 0.2;

    private final Board board;
    private Kind kind = Kind.STOP;
    private @Nullable PositionTarget target;
    private double speed;
    private double heading;
    private double turnRate;
    private double givenS;
    private boolean isPivoting;

    private enum Kind {
        STOP,
        HEADING,
        TURN_RATE,
        PLACE,
        KEEP
    }

    RoverGuidance(Board board) {
        this.board = board;
    }

    void stop() {
        kind = Kind.STOP;
        target = null;
    }

    /** Drives towards a heading; turning begins at once, whatever the speed. */
    void heading(PositionTarget newTarget, double newHeading, double newSpeed) {
        begin(Kind.HEADING, newTarget, newSpeed);
        heading = newHeading;
    }

    void turnRate(PositionTarget newTarget, double newTurnRate, double newSpeed) {
        begin(Kind.TURN_RATE, newTarget, newSpeed);
        turnRate = newTurnRate;
    }

    void place(PositionTarget newTarget, double newSpeed) {
        begin(Kind.PLACE, newTarget, newSpeed);
        isPivoting = false;
    }

    /** Stays near a place: drives back to it when it is too far away. */
    void keep(PositionTarget newTarget, double newSpeed) {
        begin(Kind.KEEP, newTarget, newSpeed);
        isPivoting = false;
    }

    private void begin(Kind newKind, PositionTarget newTarget, double newSpeed) {
        kind = newKind;
        target = newTarget;
        speed = newSpeed;
        givenS = board.boot().seconds();
    }

    /** The target in the axes of the map; null if there is none. */
    @Nullable
    PositionTarget target() {
        return target;
    }

    /** Whether a speed was not given again in time. */
    boolean isTimedOut() {
        boolean isSpeed = kind == Kind.HEADING || kind == Kind.TURN_RATE;
        return isSpeed && board.boot().seconds() - givenS > TIMEOUT_S;
    }

    /** Whether it has a place to go to, and is there. */
    boolean isThere(double north, double east, double yaw) {
        if (kind != Kind.PLACE || target == null) {
            return false;
        }
        double distance = Math.hypot(target.x() - north, target.y() - east);
        boolean isPassed = Math.abs(bearingError(target, north, east, yaw)) > Math.PI / 2;
        return distance < NEAR_M || isPassed && distance < PASSED_M;
    }

    Wish wish(double north, double east, double yaw) {
        double acceleration = board.parameter("ATC_ACCEL_MAX");
        return switch (kind) {
            case STOP -> new Wish(0, 0, BRAKING);
            case HEADING -> new Wish(speed, turnTo(Motion.wrapped(heading - yaw), "ATC_STR_RAT_MAX"), acceleration);
            case TURN_RATE -> new Wish(speed, clamped(turnRate, radians("ATC_STR_RAT_MAX")), acceleration);
            case PLACE -> wayTo(target, north, east, yaw);
            case KEEP ->
                isWithin("LOIT_RADIUS", north, east) ? new Wish(0, 0, BRAKING) : wayTo(target, north, east, yaw);
        };
    }

    private boolean isWithin(String radius, double north, double east) {
        return target != null && Math.hypot(target.x() - north, target.y() - east) < board.parameter(radius);
    }

    private Wish wayTo(@Nullable PositionTarget place, double north, double east, double yaw) {
        if (place == null) {
            return new Wish(0, 0, BRAKING);
        }
        double error = bearingError(place, north, east, yaw);
        isPivoting = Math.abs(error) > (isPivoting ? AIMED_RAD : radians("WP_PIVOT_ANGLE"));
        double acceleration = board.parameter("ATC_ACCEL_MAX");
        if (isPivoting) {
            return new Wish(0, turnTo(error, "WP_PIVOT_RATE"), acceleration);
        }
        double distance = Math.hypot(place.x() - north, place.y() - east);
        double most = Math.min(speed, Math.sqrt(2 * APPROACH * distance));
        return new Wish(most * Math.max(LEAST_SHARE, Math.cos(error)), turnTo(error, "ATC_STR_RAT_MAX"), acceleration);
    }

    private static double bearingError(PositionTarget place, double north, double east, double yaw) {
        return Motion.wrapped(Math.atan2(place.y() - east, place.x() - north) - yaw);
    }

    private double turnTo(double error, String mostDegrees) {
        return clamped(board.parameter("ATC_STR_ANG_P") * error, radians(mostDegrees));
    }

    private double radians(String parameter) {
        return Math.toRadians(board.parameter(parameter));
    }

    private static double clamped(double value, double most) {
        return Math.max(-most, Math.min(most, value));
    }
}
