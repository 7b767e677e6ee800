package majicsim.pioneer.motion;

import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import majicsim.pioneer.model.PioneerModel;
import majicsim.pioneer.model.Scaling;
import majicsim.pioneer.model.Setting;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Pose;

/**
 * The motors and their control by motion commands (ARCOS sheet 7): two independent channels, linear speed ramps, stall,
 * odometry from the wheels. Speeds and distances here are what the encoders measure; {@link WheelError} relates them to
 * the true ones.
 */
public final class Drive {
    /** Lab steps are this long; the true length comes with each step. */
    private static final double USUAL_STEP_SECONDS = 0.004;

    private static final double STALL_PAUSE_SECONDS = Setting.STALLCOUNT.stored() / 1000.0;

    private final Body body;
    private final Scaling scaling;
    private final MotionLimits tops;
    private final WheelError error;
    private final Channel translation;
    private final Channel rotation;
    private final Stall stall = new Stall();
    private final HeadingServo servo = new HeadingServo();
    private double stepSeconds = USUAL_STEP_SECONDS;
    private double plannedMmPerSec;
    private double plannedDegPerSec;
    private boolean enabled;
    private boolean held;
    private boolean wheelMode;
    private Pose odometry = new Pose(0, 0, 0);
    private Pose withoutError = new Pose(0, 0, 0);

    public Drive(Body body, PioneerModel model, Noise noise) {
        this.body = body;
        this.scaling = model.scaling();
        this.tops = MotionLimits.tops(model);
        this.error = WheelError.draw(noise);
        this.translation = new Channel(MotionLimits.stored(model).translation());
        this.rotation = new Channel(MotionLimits.stored(model).rotation());
    }

    /** Motors on, or off: then it brakes and drops its set-points. */
    public void enable(boolean on) {
        enabled = on;
        if (!on) {
            halt();
        }
    }

    public boolean isEnabled() {
        return enabled;
    }

    /** VEL: translation speed in mm/s; ends VEL2, whose turning then ends too. */
    public void velocity(double mmPerSec) {
        command(() -> {
            leaveWheelMode(rotation);
            translation.follow(new Goal.Speed(mmPerSec));
        });
    }

    /** MOVE: this distance in mm along the present heading. */
    public void move(double mm) {
        command(() -> {
            leaveWheelMode(rotation);
            translation.follow(new Goal.Position(translation.position() + mm));
        });
    }

    /** RVEL, ROTATE: turn rate in deg/s; ends VEL2, whose driving then ends too. */
    public void turnRate(double degPerSec) {
        turn(channel -> {
            servo.release();
            channel.follow(new Goal.Speed(degPerSec));
        });
    }

    /** HEAD: to this odometry heading by the shorter turn; repeated, it changes nothing. */
    public void heading(double degrees) {
        turn(channel -> servo.head(channel, odometry.headingDeg(), degrees));
    }

    /** DHEAD: to the heading that is this much from the present one, the shorter way round. */
    public void headingFromHere(double degrees) {
        turn(channel -> servo.head(channel, odometry.headingDeg(), odometry.headingDeg() + degrees));
    }

    /** DCHEAD: to the heading that is this much from the last set-point, the shorter way round. */
    public void headingFromSetPoint(double degrees) {
        turn(channel -> servo.head(channel, odometry.headingDeg(), headingSetPointDeg() + degrees));
    }

    /** VEL2: the wheels' speeds in mm/s, for both channels together. */
    public void wheels(double leftMmPerSec, double rightMmPerSec) {
        command(() -> {
            servo.release();
            translation.follow(new Goal.Speed((leftMmPerSec + rightMmPerSec) / 2));
            rotation.follow(new Goal.Speed(scaling.turnDegPerSec((rightMmPerSec - leftMmPerSec) / 2)));
            wheelMode = true;
        });
    }

    /** STOP: both channels to rest with the set deceleration; the motors stay on. */
    public void halt() {
        servo.release();
        wheelMode = false;
        translation.follow(Goal.STOP);
        rotation.follow(Goal.STOP);
        replan();
    }

    /** ESTOP, QSTOP: to rest within one SIP cycle; until then motion commands are ignored. */
    public void emergencyStop() {
        servo.release();
        wheelMode = false;
        translation.emergencyStop();
        rotation.emergencyStop();
        replan();
    }

    /** Rests and keeps the set-points while {@code on}; then continues to them with normal acceleration. */
    public void hold(boolean on) {
        held = on;
        holdChannels();
        replan();
    }

    /** Changes the translation's limits, never above what the model can do. */
    public void limitTranslation(UnaryOperator<Limits> change) {
        translation.limits(tops.capTranslation(change.apply(translation.limits())));
        replan();
    }

    /** Changes the rotation's limits, never above what the model can do. */
    public void limitRotation(UnaryOperator<Limits> change) {
        rotation.limits(tops.capRotation(change.apply(rotation.limits())));
        replan();
    }

    public MotionLimits limits() {
        return new MotionLimits(translation.limits(), rotation.limits());
    }

    /** SETO: sets the odometry; the true pose does not change. */
    public void setOdometry(Pose pose) {
        servo.shift(pose.headingDeg() - odometry.headingDeg());
        odometry = pose;
        withoutError = pose;
    }

    public Pose odometry() {
        return odometry;
    }

    /** The odometry without the errors of the wheels. */
    public Pose odometryWithoutError() {
        return withoutError;
    }

    /** The heading servo's set-point; the present heading while none is in force. */
    public double headingSetPointDeg() {
        return servo.isActive() ? servo.setPointDeg() : odometry.headingDeg();
    }

    /** The mean distance that both wheels counted since the start, in mm. */
    public double countedMm() {
        return translation.position();
    }

    /** The angle turned since the start by the wheels' count, in degrees. */
    public double countedDeg() {
        return rotation.position();
    }

    public double speedMmPerSec() {
        return translation.speed();
    }

    public double turnDegPerSec() {
        return rotation.speed();
    }

    public Stall stall() {
        return stall;
    }

    /** What the coming step is meant to cover. */
    public double plannedMmPerSec() {
        return plannedMmPerSec;
    }

    /** Reports a contact of a bumper: it stops, stalled. */
    public void bumped() {
        translation.blockAfter(0);
        stall.pushed(STALL_PAUSE_SECONDS);
        holdChannels();
        replan();
    }

    /** Completes the step that the world has just made, and plans the next. */
    public void step(double seconds) {
        stepSeconds = seconds;
        stall.step(seconds);
        double way = settle(translation, plannedMmPerSec, body.speedMmPerSec() / error.way());
        double turn = settle(rotation, plannedDegPerSec, body.turnDegPerSec() / error.turn());
        odometry = odometry.driven(way, turn);
        withoutError = withoutError.driven(way * error.way(), turn * error.turn());
        holdChannels();
        replan();
        if (plannedMmPerSec == 0 && plannedDegPerSec == 0 && (!stall.isPausing() || isCommandedToStop())) {
            stall.rests();
        }
    }

    /** Whether it is stationary and stays so until the next command. */
    public boolean isAtRest() {
        return translation.isAtRest() && rotation.isAtRest() && !stall.isPausing();
    }

    private boolean isCommandedToStop() {
        return translation.goal().equals(Goal.STOP) && rotation.goal().equals(Goal.STOP);
    }

    /** Without power, without packets from a client or after a stall, the motors rest and keep their set-points. */
    private void holdChannels() {
        boolean hold = held || stall.isPausing();
        translation.hold(hold);
        rotation.hold(hold);
    }

    /** Returns the motion of the channel in the step, in mm or degrees. */
    private double settle(Channel channel, double plannedPerSec, double donePerSec) {
        if (plannedPerSec == 0) {
            channel.follow();
            return 0;
        }
        double done = donePerSec * stepSeconds;
        if (body.blocked() && Math.abs(donePerSec) < Math.abs(plannedPerSec) * 0.999) {
            channel.blockAfter(done);
            stall.pushed(STALL_PAUSE_SECONDS);
            return done;
        }
        double planned = plannedPerSec * stepSeconds;
        channel.follow();
        stall.moved(planned);
        return planned;
    }

    private void command(Runnable change) {
        if (enabled) {
            change.run();
            replan();
        }
    }

    private void turn(Consumer<Channel> change) {
        command(() -> {
            leaveWheelMode(translation);
            change.accept(rotation);
        });
    }

    private void leaveWheelMode(Channel other) {
        if (wheelMode) {
            wheelMode = false;
            other.follow(Goal.STOP);
        }
    }

    private void replan() {
        plannedMmPerSec = translation.plan(stepSeconds);
        plannedDegPerSec = rotation.plan(stepSeconds);
        body.velocity(plannedMmPerSec * error.way(), plannedDegPerSec * error.turn());
    }
}
