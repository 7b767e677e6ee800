package majicsim.mavlink;

import java.util.List;
import majicsim.mavlink.Flight.Velocity;
import org.jspecify.annotations.Nullable;

/** A quadcopter as ArduCopter 4.6. */
final class Copter extends Vehicle {
    static final double RADIUS_MM = 250;

    private static final double HOVER_AMPERES = 18;
    private static final double REST_AMPERES = 0.3;
    private static final double CENTIMETRES = 100;
    private static final double LANDED_DISARM_S = 1;
    private static final double THROTTLE_LOW = 1130;
    private static final double NEAR_HOME_M = 0.4;
    private static final int ROLL = 1;
    private static final int PITCH = 2;
    private static final int THROTTLE = 3;
    private static final int YAW = 4;
    private static final double STICK_SPEED = 5;
    private static final double STICK_YAW_RATE = Math.toRadians(90);
    private static final int FS_LAND = 5;
    private static final int FS_BRAKE = 7;

    private final Flight flight;
    private final CopterGuidance guidance;
    private Mode mode = Mode.STABILIZE;
    private double onGroundS;
    private double aboveHomeS;
    private boolean isComingDown;
    private int disarmsInFlight;

    /** The modes that exist, by the numbers of sheet 3. */
    private enum Mode {
        STABILIZE(0, false),
        ACRO(1, false),
        ALT_HOLD(2, false),
        AUTO(3, true),
        GUIDED(4, true),
        LOITER(5, true),
        RTL(6, true),
        CIRCLE(7, true),
        LAND(9, false),
        DRIFT(11, true),
        AUTOTUNE(15, true),
        POSHOLD(16, true),
        BRAKE(17, true),
        AVOID_ADSB(19, true),
        GUIDED_NOGPS(20, false),
        SMART_RTL(21, true);

        private final int number;
        private final boolean needsPosition;

        Mode(int number, boolean needsPosition) {
            this.number = number;
            this.needsPosition = needsPosition;
        }

        static @Nullable Mode of(int number) {
            for (Mode mode : values()) {
                if (mode.number == number) {
                    return mode;
                }
            }
            return null;
        }
    }

    Copter(Board board, Flight flight) {
        super(board);
        this.flight = flight;
        this.guidance = new CopterGuidance(board, flight);
    }

    /** The times at which it was disarmed in the air. */
    int disarmsInFlight() {
        return disarmsInFlight;
    }

    Flight flight() {
        return flight;
    }

    @Override
    void restarted() {
        mode = Mode.STABILIZE;
        guidance.hold();
    }

    @Override
    int mode() {
        return mode.number;
    }

    @Override
    boolean isMode(int number) {
        return Mode.of(number) != null;
    }

    @Override
    boolean enter(int number) {
        Mode wanted = Mode.of(number);
        String reason = wanted == null ? "init failed" : refusal(wanted);
        if (wanted == null || !reason.isEmpty()) {
            say(Announcements.WARNING, "Mode change to " + wanted + " failed: " + reason);
            return false;
        }
        mode = wanted;
        aboveHomeS = 0;
        isComingDown = wanted == Mode.LAND;
        guidance.hold();
        return true;
    }

    private String refusal(Mode wanted) {
        if (wanted.needsPosition && !board().boot().hasPosition()) {
            return "requires position";
        }
        return wanted == Mode.AUTO || wanted == Mode.AUTOTUNE ? "init failed" : "";
    }

    @Override
    int landingMode() {
        return Mode.LAND.number;
    }

    @Override
    int returningMode() {
        return Mode.RTL.number;
    }

    @Override
    int guidedMode() {
        return Mode.GUIDED.number;
    }

    @Override
    int modeBits() {
        return MANUAL_INPUT | STABILIZED | (mode.needsPosition ? GUIDED_BY_ITSELF : 0);
    }

    @Override
    int usualStatus() {
        return flight.isOnGround() ? STANDBY : ACTIVE;
    }

    @Override
    int landedState() {
        if (flight.isOnGround()) {
            return LandedState.ON_GROUND;
        }
        if (mode == Mode.GUIDED && guidance.isTakingOff()) {
            return LandedState.TAKING_OFF;
        }
        return isComingDown ? LandedState.LANDING : LandedState.IN_AIR;
    }

    /** The numbers of EXTENDED_SYS_STATE. */
    private interface LandedState {
        int ON_GROUND = 1;
        int IN_AIR = 2;
        int TAKING_OFF = 3;
        int LANDING = 4;
    }

    @Override
    int throttlePercent() {
        return flight.isOnGround() ? 0 : 40;
    }

    @Override
    double amperes() {
        return isArmed() && !flight.isOnGround() ? HOVER_AMPERES : REST_AMPERES;
    }

    @Override
    List<String> ownArmingFailures() {
        return switch (mode) {
            case RTL, LAND, BRAKE, CIRCLE, DRIFT, AVOID_ADSB, SMART_RTL -> List.of(mode + " mode not armable");
            default -> List.of();
        };
    }

    @Override
    boolean refusesDisarm() {
        return !flight.isOnGround();
    }

    @Override
    void armedChanged() {
        onGroundS = 0;
        guidance.hold();
        say(Announcements.NOTICE, isArmed() ? "Arming motors" : "Disarming motors");
        disarmsInFlight += isArmed() || flight.isOnGround() ? 0 : 1;
    }

    @Override
    double failsafeDelayS() {
        return parameter("FS_GCS_TIMEOUT");
    }

    @Override
    boolean heedsFailsafe() {
        return isArmed();
    }

    @Override
    void enterFailsafe() {
        say(Announcements.WARNING, "GCS Failsafe");
        if (flight.isOnGround()) {
            disarm(true);
            return;
        }
        Mode wanted = switch ((int) parameter("FS_GCS_ENABLE")) {
            case FS_LAND -> Mode.LAND;
            case FS_BRAKE -> Mode.BRAKE;
            default -> Mode.RTL;
        };
        if (!(mode == Mode.LAND || wanted == mode || enter(wanted.number))) {
            enter(Mode.LAND.number);
        }
    }

    @Override
    CommandResult takeOff(double metresAboveHome) {
        double height = metresAboveHome + board().filter().homeHeight();
        boolean canTakeOff = isArmed() && mode == Mode.GUIDED && flight.isOnGround() && height > flight.height() + 0.1;
        if (!canTakeOff) {
            return CommandResult.FAILED;
        }
        guidance.takeOff(height);
        return CommandResult.ACCEPTED;
    }

    @Override
    boolean speed(double metresPerSec) {
        boolean isPossible = metresPerSec > 0;
        if (isPossible) {
            guidance.speed(metresPerSec);
        }
        return isPossible;
    }

    @Override
    boolean goTo(double north, double east, double height) {
        if (mode != Mode.GUIDED || !Double.isFinite(height)) {
            return false;
        }
        if (!flight.isOnGround()) {
            guidance.aim(PositionTarget.place(north, east, -height));
        }
        return true;
    }

    @Override
    @Nullable
    PositionTarget aimed() {
        return mode == Mode.GUIDED ? guidance.target() : null;
    }

    /** A target on the ground is dropped; one in the air that does not fit ends the present one (4.6). */
    @Override
    void aim(PositionTarget target) {
        if (mode == Mode.GUIDED && isArmed() && !flight.isOnGround()) {
            guidance.aim(target);
        }
    }

    @Override
    void move(double seconds) {
        if (!isArmed()) {
            if (flight.isOnGround()) {
                flight.rest();
            } else {
                flight.fall(seconds);
            }
            return;
        }
        disarmOnGround(seconds);
        Velocity wanted = wanted(seconds);
        if (flight.isOnGround() && wanted.up() <= 0) {
            flight.rest();
        } else {
            flight.fly(wanted, seconds);
        }
    }

    /** After a landing at once, otherwise after a while with the throttle low (DISARM_DELAY). */
    private void disarmOnGround(double seconds) {
        boolean isThrottleLow = board().radio().micros(THROTTLE) < THROTTLE_LOW;
        boolean isWaiting = guidance.isTakingOff() && mode == Mode.GUIDED;
        onGroundS = flight.isOnGround() && !isWaiting && (isThrottleLow || isComingDown) ? onGroundS + seconds : 0;
        double delayS = isComingDown ? LANDED_DISARM_S : parameter("DISARM_DELAY");
        if (delayS > 0 && onGroundS >= delayS) {
            disarm(false);
        }
    }

    private Velocity wanted(double seconds) {
        return switch (mode) {
            case GUIDED -> guidance.wanted();
            case LAND -> descending();
            case RTL, SMART_RTL -> returning(seconds);
            case BRAKE, CIRCLE, AUTO, AVOID_ADSB, GUIDED_NOGPS -> guidance.holding();
            case STABILIZE, ACRO, ALT_HOLD, LOITER, DRIFT, AUTOTUNE, POSHOLD -> byStick();
        };
    }

    private Velocity descending() {
        boolean isHigh = flight.height() > parameter("LAND_ALT_LOW") / CENTIMETRES;
        double speed = parameter(isHigh ? "WPNAV_SPEED_DN" : "LAND_SPEED") / CENTIMETRES;
        Velocity holding = guidance.holding();
        return new Velocity(holding.north(), holding.east(), -speed, 0);
    }

    /** Climbs to RTL_ALT, flies home, waits there and lands. */
    private Velocity returning(double seconds) {
        if (isComingDown) {
            return descending();
        }
        double height = board().filter().homeHeight() + parameter("RTL_ALT") / CENTIMETRES;
        if (flight.height() < height - NEAR_HOME_M && aboveHomeS == 0 && !guidance.isGoingTo(height)) {
            return guidance.climbing(height);
        }
        double north = board().filter().homeNorth();
        double east = board().filter().homeEast();
        guidance.aim(PositionTarget.place(north, east, -Math.max(height, flight.height())));
        if (guidance.isThere(NEAR_HOME_M)) {
            aboveHomeS += seconds;
        }
        if (aboveHomeS * 1000 >= parameter("RTL_LOIT_TIME")) {
            isComingDown = true;
            guidance.hold();
            return descending();
        }
        return guidance.wanted();
    }

    /** The sticks give velocities; a throttle that is low makes it sink (sheet 9). */
    private Velocity byStick() {
        double forward = -board().radio().stick(PITCH) * STICK_SPEED;
        double right = board().radio().stick(ROLL) * STICK_SPEED;
        double climb = board().radio().stick(THROTTLE) * parameter("PILOT_SPEED_UP") / CENTIMETRES;
        double turn = board().radio().stick(YAW) * STICK_YAW_RATE;
        if (forward == 0 && right == 0) {
            Velocity holding = guidance.holding();
            return new Velocity(holding.north(), holding.east(), climb, turn);
        }
        guidance.hold();
        double yaw = flight.motion().yaw();
        return new Velocity(
                forward * Math.cos(yaw) - right * Math.sin(yaw),
                forward * Math.sin(yaw) + right * Math.cos(yaw),
                climb,
                turn);
    }

    @Override
    boolean isResting() {
        return !isArmed() && flight.isOnGround();
    }

    @Override
    Motion motion() {
        return flight.motion();
    }
}
