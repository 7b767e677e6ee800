package majicsim.mavlink;

import majicsim.mavlink.Flight.Velocity;
import org.jspecify.annotations.Nullable;

/**
 * How a copter follows its target: a take-off, a place, or a velocity, which ends GUID_TIMEOUT after it was last given
 * and leaves it hovering (sheet 9). Places are in m from the origin, heights above the floor.
 */
final class CopterGuidance {
    private static final double CENTIMETRES = 100;
    private static final double ACCELERATION = 1.2;
    private static final double GAIN = 1;
    private static final double NEAR_M = 0.1;
    private static final double SLOW = 0.15;
    private static final double YAW_GAIN = 2;
    private static final double MOST_YAW_RATE = Math.toRadians(60);
    private static final double NOSE_M = 1;
    private static final double LEAST_CLIMB = 0.2;

    private final Board board;
    private final Flight flight;
    private Kind kind = Kind.HOLD;
    private @Nullable PositionTarget target;
    private @Nullable PositionTarget held;
    private double takeOffHeight;
    private double givenS;
    private double speed;

    private enum Kind {
        HOLD,
        TAKE_OFF,
        PLACE,
        VELOCITY
    }

    CopterGuidance(Board board, Flight flight) {
        this.board = board;
        this.flight = flight;
    }

    /** Stops, then keeps the place. */
    void hold() {
        kind = Kind.HOLD;
        target = null;
        held = null;
        speed = board.parameter("WPNAV_SPEED") / CENTIMETRES;
    }

    void takeOff(double height) {
        hold();
        kind = Kind.TAKE_OFF;
        takeOffHeight = height;
    }

    boolean isTakingOff() {
        return kind == Kind.TAKE_OFF;
    }

    /** Sets the speed on the way to places, m/s. */
    void speed(double metresPerSec) {
        speed = metresPerSec;
    }

    /** The target in the axes of the map; null if there is none. */
    @Nullable
    PositionTarget target() {
        return target;
    }

    /** Takes a target in any frame; one that is not possible ends the present one. */
    void aim(PositionTarget wanted) {
        Motion now = flight.motion();
        PositionTarget inMap = wanted.inMap(north(now), east(now), -now.height(), now.yaw());
        boolean hasPlace = wanted.has(PositionTarget.POSITION);
        boolean hasVelocity = wanted.has(PositionTarget.VELOCITY);
        if (!wanted.hasKnownFrame() || !hasPlace && !hasVelocity) {
            hold();
            return;
        }
        kind = hasPlace ? Kind.PLACE : Kind.VELOCITY;
        target = inMap;
        held = null;
        givenS = board.boot().seconds();
    }

    /** Whether it is on its way to a place of this height. */
    boolean isGoingTo(double height) {
        return kind == Kind.PLACE && target != null && -target.z() >= height;
    }

    /** Whether it is so near to the place that is its target. */
    boolean isThere(double withinM) {
        Motion now = flight.motion();
        return kind == Kind.PLACE
                && target != null
                && Math.hypot(target.x() - north(now), target.y() - east(now)) < withinM;
    }

    Velocity wanted() {
        PositionTarget now = target;
        return switch (kind) {
            case HOLD -> holding();
            case TAKE_OFF -> takingOff();
            case PLACE -> now == null ? holding() : to(now, speed);
            case VELOCITY -> now == null || isTimedOut() ? holding() : velocity(now);
        };
    }

    private boolean isTimedOut() {
        return board.boot().seconds() - givenS > board.parameter("GUID_TIMEOUT");
    }

    private static Velocity velocity(PositionTarget at) {
        double yawRate = at.has(PositionTarget.YAW_RATE) ? at.yawRate() : 0;
        return new Velocity(at.vx(), at.vy(), -at.vz(), yawRate);
    }

    private Velocity takingOff() {
        if (flight.height() >= takeOffHeight - NEAR_M) {
            Motion now = flight.motion();
            kind = Kind.HOLD;
            held = PositionTarget.place(north(now), east(now), -takeOffHeight);
        }
        return climbing(takeOffHeight);
    }

    /** Climbs straight up to a height. */
    Velocity climbing(double height) {
        double left = Math.max(0, height - flight.height());
        double most = board.parameter("WPNAV_SPEED_UP") / CENTIMETRES;
        double up = Math.min(most, Math.max(LEAST_CLIMB, Math.sqrt(2 * ACCELERATION * left)));
        return new Velocity(0, 0, up, 0);
    }

    /** Stops first; once it is slow, it keeps the place at which it is then. */
    Velocity holding() {
        Motion now = flight.motion();
        if (held == null) {
            if (now.groundSpeed() > SLOW || Math.abs(now.climb()) > SLOW) {
                return Velocity.NONE;
            }
            held = PositionTarget.place(north(now), east(now), -now.height());
        }
        return to(held, speed);
    }

    private Velocity to(PositionTarget place, double most) {
        Motion now = flight.motion();
        double northError = place.x() - north(now);
        double eastError = place.y() - east(now);
        double distance = Math.hypot(northError, eastError);
        double wanted = Math.min(most, approach(distance));
        double share = distance == 0 ? 0 : wanted / distance;
        return new Velocity(
                northError * share, eastError * share, climbTo(-place.z(), now), yawRate(place, distance, now));
    }

    private double climbTo(double height, Motion now) {
        double error = height - now.height();
        double most = board.parameter(error > 0 ? "WPNAV_SPEED_UP" : "WPNAV_SPEED_DN") / CENTIMETRES;
        return Math.signum(error) * Math.min(most, approach(Math.abs(error)));
    }

    private static double approach(double distance) {
        return Math.min(GAIN * distance, Math.sqrt(2 * ACCELERATION * distance));
    }

    /** Turns the nose to a place that is far away, unless the target says otherwise. */
    private double yawRate(PositionTarget place, double distance, Motion now) {
        if (kind != Kind.PLACE) {
            return 0;
        }
        if (place.has(PositionTarget.YAW_RATE)) {
            return place.yawRate();
        }
        if (!place.has(PositionTarget.YAW) && distance < NOSE_M) {
            return 0;
        }
        double wanted =
                place.has(PositionTarget.YAW) ? place.yaw() : Math.atan2(place.y() - east(now), place.x() - north(now));
        double rate = YAW_GAIN * Motion.wrapped(wanted - now.yaw());
        return Math.max(-MOST_YAW_RATE, Math.min(MOST_YAW_RATE, rate));
    }

    private double north(Motion now) {
        return board.filter().north(now);
    }

    private double east(Motion now) {
        return board.filter().east(now);
    }
}
