package majicsim.mavlink;

import java.util.List;
import majicsim.mavlink.SkidDrive.Wish;
import majicsim.mavlink.message.Message;
import majicsim.mavlink.message.MessageType;
import majicsim.world.Body;
import majicsim.world.Pose;
import org.jspecify.annotations.Nullable;

/** A rover or boat as ArduRover 4.6 with skid steering. */
final class Rover extends Vehicle {
    static final double HALF_LENGTH_MM = 300;
    static final double HALF_WIDTH_MM = 200;

    /** The speed at full throttle in the manual modes, m/s; 1700 µs are then 2.9 m/s (sheet 12). */
    private static final double TOP_SPEED = 6.3;

    private static final double MANUAL_ACCELERATION = 3;
    private static final double REST_AMPERES = 0.3;
    private static final double AMPERES_A_SPEED = 6;
    private static final int STEERING = 1;
    private static final int THROTTLE = 3;
    private static final int FS_NOTHING = 0;
    private static final int FS_RTL = 1;
    private static final int FS_SMART_RTL = 3;
    private static final double MM = 1000;

    private final Body body;
    private final SkidDrive drive;
    private final RoverGuidance guidance;
    private Mode mode = Mode.INITIALISING;
    private double waySpeed;

    /** The modes that exist, by the numbers of sheet 3. */
    private enum Mode {
        MANUAL(0, MANUAL_INPUT),
        ACRO(1, MANUAL_INPUT),
        STEERING(3, MANUAL_INPUT),
        HOLD(4, 0),
        LOITER(5, GUIDED_BY_ITSELF),
        FOLLOW(6, GUIDED_BY_ITSELF),
        SIMPLE(7, MANUAL_INPUT),
        CIRCLE(9, GUIDED_BY_ITSELF),
        AUTO(10, GUIDED_BY_ITSELF),
        RTL(11, GUIDED_BY_ITSELF),
        SMART_RTL(12, GUIDED_BY_ITSELF),
        GUIDED(15, GUIDED_BY_ITSELF),
        INITIALISING(16, MANUAL_INPUT);

        private final int number;
        private final int bits;

        Mode(int number, int bits) {
            this.number = number;
            this.bits = bits;
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

    Rover(Board board, Body body) {
        super(board);
        this.body = body;
        this.drive = new SkidDrive(body);
        this.guidance = new RoverGuidance(board);
    }

    @Override
    void restarted() {
        mode = Mode.INITIALISING;
        guidance.stop();
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
        if (wanted == null || !canEnter(wanted)) {
            return false;
        }
        mode = wanted;
        waySpeed = parameter("WP_SPEED");
        guidance.stop();
        switch (mode) {
            case RTL, SMART_RTL ->
                guide(PositionTarget.place(
                        board().filter().homeNorth(), board().filter().homeEast(), 0));
            case LOITER, CIRCLE -> keepPlace();
            default -> {}
        }
        return true;
    }

    private boolean canEnter(Mode wanted) {
        return switch (wanted) {
            case AUTO -> {
                say(Announcements.NOTICE, "No Mission. Can't set AUTO.");
                yield false;
            }
            case FOLLOW, INITIALISING -> false;
            case LOITER, CIRCLE, RTL, SMART_RTL -> board().boot().hasPosition();
            case MANUAL, ACRO, STEERING, HOLD, SIMPLE, GUIDED -> true;
        };
    }

    @Override
    int landingMode() {
        return -1;
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
        return mode.bits;
    }

    @Override
    int usualStatus() {
        return mode == Mode.HOLD ? STANDBY : ACTIVE;
    }

    @Override
    int landedState() {
        return 0;
    }

    @Override
    int throttlePercent() {
        return (int) Math.min(100, Math.round(Math.abs(drive.speed()) / TOP_SPEED * 100));
    }

    @Override
    double amperes() {
        return REST_AMPERES + AMPERES_A_SPEED * Math.abs(drive.speed());
    }

    @Override
    List<String> ownArmingFailures() {
        return List.of();
    }

    @Override
    boolean refusesDisarm() {
        return false;
    }

    @Override
    void armedChanged() {
        say(Announcements.INFO, isArmed() ? "Throttle armed" : "Throttle disarmed");
    }

    @Override
    double failsafeDelayS() {
        return parameter("FS_GCS_TIMEOUT") + parameter("FS_TIMEOUT");
    }

    @Override
    boolean heedsFailsafe() {
        return mode != Mode.HOLD && mode != Mode.RTL && mode != Mode.SMART_RTL && mode != Mode.INITIALISING;
    }

    @Override
    void enterFailsafe() {
        say(Announcements.WARNING, "Radio Failsafe");
        int action = (int) parameter("FS_ACTION");
        boolean returns = action == FS_RTL || action == FS_SMART_RTL;
        if (action != FS_NOTHING && !(returns && enter(Mode.RTL.number))) {
            enter(Mode.HOLD.number);
        }
    }

    @Override
    CommandResult takeOff(double metresAboveHome) {
        return CommandResult.UNSUPPORTED;
    }

    @Override
    boolean speed(double metresPerSec) {
        boolean isPossible = metresPerSec >= 0 && mode.bits == GUIDED_BY_ITSELF;
        if (isPossible) {
            waySpeed = metresPerSec;
            PositionTarget target = guidance.target();
            if (target != null && target.has(PositionTarget.HORIZONTAL_POSITION)) {
                guidance.place(target, waySpeed);
            }
        }
        return isPossible;
    }

    @Override
    boolean goTo(double north, double east, double height) {
        if (mode != Mode.GUIDED || !board().boot().hasOrigin()) {
            return false;
        }
        guide(PositionTarget.place(north, east, 0));
        return true;
    }

    @Override
    @Nullable
    PositionTarget aimed() {
        return guidance.target();
    }

    /** As the firmware does: what does not fit is dropped without a word (sheet 7 and 12). */
    @Override
    void aim(PositionTarget target) {
        if (mode != Mode.GUIDED || !target.hasKnownFrame() || !board().boot().hasOrigin()) {
            return;
        }
        Motion now = motion();
        PositionTarget inMap = target.inMap(north(now), east(now), 0, now.yaw());
        boolean hasSpeed = target.has(PositionTarget.HORIZONTAL_VELOCITY);
        boolean hasYaw = target.has(PositionTarget.YAW);
        boolean hasYawRate = target.has(PositionTarget.YAW_RATE);
        if (target.has(PositionTarget.HORIZONTAL_POSITION)) {
            guide(inMap);
        } else if (!target.has(PositionTarget.ACCELERATION) && hasYawRate && !hasYaw) {
            guidance.turnRate(inMap, target.yawRate(), hasSpeed ? signedSpeed(target) : 0);
        } else if (!target.has(PositionTarget.ACCELERATION) && hasYaw && !hasYawRate) {
            guidance.heading(inMap, inMap.yaw(), hasSpeed ? signedSpeed(target) : 0);
        } else if (!target.has(PositionTarget.ACCELERATION) && hasSpeed && !hasYaw) {
            guidance.heading(inMap, Math.atan2(inMap.vy(), inMap.vx()), speed(target));
        }
    }

    private double signedSpeed(PositionTarget target) {
        return target.vx() < 0 ? -speed(target) : speed(target);
    }

    private double speed(PositionTarget target) {
        double most = Math.max(parameter("WP_SPEED"), parameter("CRUISE_SPEED"));
        return Math.min(most, Math.hypot(target.vx(), target.vy()));
    }

    private void guide(PositionTarget place) {
        guidance.place(place, waySpeed);
    }

    private void keepPlace() {
        Motion now = motion();
        guidance.keep(PositionTarget.place(north(now), east(now), 0), waySpeed);
    }

    @Override
    void move(double seconds) {
        if (mode == Mode.INITIALISING && board().boot().isInitialised()) {
            enter((int) parameter("INITIAL_MODE"));
        }
        Wish wish = isArmed() ? wish() : new Wish(0, 0, RoverGuidance.BRAKING);
        drive.step(wish, Math.toRadians(parameter("ATC_STR_ACC_MAX")), seconds);
    }

    private Wish wish() {
        return switch (mode) {
            case MANUAL, ACRO, STEERING, SIMPLE ->
                new Wish(
                        board().radio().stick(THROTTLE) * TOP_SPEED,
                        board().radio().stick(STEERING) * Math.toRadians(parameter("ATC_STR_RAT_MAX")),
                        MANUAL_ACCELERATION);
            case GUIDED, RTL, SMART_RTL, LOITER, CIRCLE -> guided();
            case HOLD, FOLLOW, AUTO, INITIALISING -> new Wish(0, 0, RoverGuidance.BRAKING);
        };
    }

    private Wish guided() {
        Motion now = motion();
        if (guidance.isTimedOut()) {
            say(Announcements.WARNING, "target not received last 3secs, stopping");
            rest();
        } else if (guidance.isThere(north(now), east(now), now.yaw())) {
            board().announcements().post(new Message(MessageType.MISSION_ITEM_REACHED));
            rest();
        }
        return guidance.wish(north(now), east(now), now.yaw());
    }

    /** A rover stops its motors, a boat keeps its place. */
    private void rest() {
        guidance.stop();
        if (board().kind() == VehicleKind.BOAT) {
            keepPlace();
        }
    }

    private double north(Motion now) {
        return board().filter().north(now);
    }

    private double east(Motion now) {
        return board().filter().east(now);
    }

    @Override
    boolean isResting() {
        return drive.isResting() && !isArmed() && body.speedMmPerSec() == 0 && body.turnDegPerSec() == 0;
    }

    @Override
    Motion motion() {
        Pose pose = body.pose();
        double yaw = Motion.yawOf(pose.headingDeg());
        double speed = body.speedMmPerSec() / MM;
        return new Motion(
                pose.yMm() / MM,
                pose.xMm() / MM,
                0,
                speed * Math.cos(yaw),
                speed * Math.sin(yaw),
                0,
                0,
                0,
                yaw,
                -Math.toRadians(body.turnDegPerSec()));
    }
}
