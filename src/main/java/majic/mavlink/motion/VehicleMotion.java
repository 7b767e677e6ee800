package majic.mavlink.motion;

import java.util.Optional;
import majic.bot.BotException;
import majic.bot.BotState;
import majic.bot.LinkLost;
import majic.bot.MotionFailed;
import majic.bot.Pose;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.Motion;
import majic.driver.RobotWait;
import majic.mavlink.message.AttitudeReport;
import majic.mavlink.message.GlobalPosition;
import majic.mavlink.message.LocalPosition;
import majic.mavlink.message.MavlinkRequests;
import majic.mavlink.message.VehicleHeartbeat;
import majic.mavlink.session.Received;
import majic.mavlink.session.VehicleClass;
import majic.mavlink.session.VehicleSession;
import majic.time.TimeSource;
import majic.time.WaitPolicy;
import majic.velocity.BaseDynamics;
import majic.velocity.BaseOwner;
import majic.velocity.LastOdometry;
import majic.velocity.Obstruction;
import majic.velocity.ObstructionSource;
import majic.velocity.VelocityMotion;
import majic.velocity.VelocityMotion.PoseSource;
import org.jspecify.annotations.Nullable;

/**
 * What moves one vehicle during one connection. A vehicle on the surface or a copter is driven by velocities in the
 * mode GUIDED, which its autopilot follows for 3 s at most; others are only stopped. Thread-safe.
 */
public final class VehicleMotion {
    /** An attitude that was measured longer before or after a position does not belong to it, seconds. */
    private static final double ATTITUDE_S = 0.2;

    /** A drive whose mode was taken over is not begun again by calls within this time of the last one, seconds. */
    private static final double TAKEN_OVER_S = 1;

    /** A global position that is older says nothing about whether the local one is known, seconds. */
    private static final double GLOBAL_S = 3;

    /** A vehicle that others than MAJIC stop comes to rest within this time, seconds. */
    private static final double REST_S = 6;

    private static final double RESTING_MM_PER_SEC = 300;

    /** A pose that is older is not that of a scan, seconds. */
    private static final double POSE_S = 0.3;

    private final MotionOwner owner;
    private final VehicleSession session;
    private final TimeSource time;
    private final StopControl stop;
    private final GuidedMode mode;
    private final FlightGuard flight;
    private final Arming arming;
    private final VelocityTargets targets;
    private final VelocityMotion velocities;
    private final BootClock bootClock = new BootClock();
    private volatile long droveNanos;
    private volatile boolean stopDue;

    /** What the motions use of the driver. */
    public interface MotionOwner {
        /** The name of the robot in messages. */
        String name();

        /** The clock, and the signal that is raised after each message. */
        RobotWait waiting();

        /** Runs a task once on the timer thread; one of the same name is replaced. */
        void once(String what, double seconds, Runnable task);

        /** Publishes where the vehicle is. */
        void publish(BotState state);

        /** Sends a notice to the user. */
        void notice(String message);

        /** Whether a motion may arm the vehicle. */
        boolean armsByMotion();

        /** The space in which an aircraft may fly; null if none was set. */
        @Nullable
        FlightFence fence();
    }

    /**
     * Creates the motions; sends nothing.
     *
     * @param dynamics the limits of the vehicle
     * @param before where it was before its connection was lost
     */
    public VehicleMotion(MotionOwner owner, VehicleSession session, BaseDynamics dynamics, LastOdometry before) {
        this.owner = owner;
        this.session = session;
        this.time = owner.waiting().time();
        this.stop = new StopControl(session, time, this::scheduleStop);
        this.mode = new GuidedMode(session, stop, time);
        this.flight = new FlightGuard(session, time, owner::fence);
        this.arming = new Arming(session, mode, flight, time);
        this.targets = new VelocityTargets(session, mode, time);
        this.velocities = new VelocityMotion(new Base(), targets, dynamics, before, PoseSource.ODOMETRY);
    }

    private void scheduleStop() {
        owner.once("mavlink stop", StopControl.PERIOD_S, stop::repeat);
    }

    /**
     * Begins; sends a stop if the vehicle may still move by commands of an earlier connection.
     *
     * @param mayMove whether it may
     */
    public void begin(boolean mayMove) {
        if (mayMove && (session.vehicle().isOnSurface() || flies() && mode.isShown())) {
            orderStop();
        }
    }

    /** Whether it is a copter that MAJIC flies. */
    private boolean flies() {
        return session.vehicle() == VehicleClass.COPTER;
    }

    /** Takes a new position; on the reader thread. */
    public void moved() {
        LocalPosition position =
                session.reports().newest(LocalPosition.class).orElseThrow().value();
        long measuredNanos = bootClock.measuredNanos(position.bootMs(), time.nanos());
        Received<AttitudeReport> received =
                session.reports().attitudeAt(position.bootMs()).orElse(null);
        if (received == null || !received.value().isUsable() || !position.isUsable()) {
            velocities.unusable("the autopilot reports no attitude");
            return;
        }
        AttitudeReport attitude = received.value();
        double apartS = apartS(received, position);
        if (apartS > ATTITUDE_S) {
            velocities.unusable("attitude and position are of moments " + Value.plain(apartS) + " s apart");
            return;
        }
        if (position.isZero() && !isPlaced()) {
            velocities.unusable("the autopilot has no position yet");
            return;
        }
        double yaw = Math.toRadians(attitude.yawDeg());
        double speed = 1000 * (position.northMPerSec() * Math.cos(yaw) + position.eastMPerSec() * Math.sin(yaw));
        Pose raw = new Pose(1000 * position.northM(), -1000 * position.eastM(), -attitude.yawDeg());
        velocities.reported(raw, speed, -attitude.yawDegPerSec(), measuredNanos);
    }

    /** By the clock of the autopilot; reports without a time belong to that of their arrival. */
    private double apartS(Received<AttitudeReport> attitude, LocalPosition position) {
        long ms = position.bootMs() - attitude.value().bootMs();
        return position.bootMs() == 0 || attitude.value().bootMs() == 0
                ? time.secondsSince(attitude.atNanos())
                : Math.abs(ms) / 1e3;
    }

    private boolean isPlaced() {
        return session.reports()
                .newest(GlobalPosition.class, GLOBAL_S)
                .filter(GlobalPosition::isKnown)
                .isPresent();
    }

    /** Takes a heartbeat; on the reader thread. */
    public void heartbeat(VehicleHeartbeat heartbeat) {
        mode.heartbeat(heartbeat);
        if (!heartbeat.armed()) {
            flight.disarmed();
        }
    }

    /** Takes a position on the earth; on the reader thread. Stops a copter that leaves its fence. */
    public void located() {
        if (flies() && mode.isHeld() && flight.leaves()) {
            orderStop();
        }
    }

    /** Takes a text of the autopilot; on the reader thread. */
    public void said(String text) {
        flight.said(text);
    }

    /** Whether a text is the one with which a vehicle that stands ends its target, 3 s after the end of a motion. */
    public boolean isExpected(String text) {
        return text.startsWith("target not received") && !isMoving();
    }

    /** Takes the restart of the autopilot; on the reader thread. */
    public void restarted() {
        mode.restarted();
        flight.disarmed();
    }

    /** Whether there has been a usable position. */
    public boolean isLocated() {
        return velocities.hasReported();
    }

    /** Where the vehicle was last. */
    public LastOdometry last() {
        return velocities.last();
    }

    /** Where a copter was armed by MAJIC's command, from where it was added; empty if it was not. */
    public Optional<Pose> home() {
        LastOdometry now = velocities.last();
        return Optional.ofNullable(flight.homeInOdometry())
                .map(home -> now.pose().plus(home.seenFrom(now.raw())));
    }

    /**
     * Takes note that a motion begins that was commanded anew, and so may take back a vehicle that another has taken
     * over, or that a failsafe has.
     *
     * @param drives whether it is a drive, which is none within 1 s of the last call for another
     */
    public void begins(boolean drives) {
        if (!drives || droveNanos == 0 || time.secondsSince(droveNanos) >= TAKEN_OVER_S) {
            mode.begins();
            flight.begins();
        }
    }

    /**
     * Moves straight.
     *
     * @param mm ahead positive
     * @param cruiseMmPerSec the highest speed
     * @return the distance covered
     * @throws MotionFailed if the vehicle cannot be moved, or something ended the motion
     */
    public Value move(double mm, double cruiseMmPerSec, Motion motion) {
        return prepare(motion, mm) ? velocities.move(mm, cruiseMmPerSec, motion) : Value.of(0, Unit.MM);
    }

    /**
     * Turns on the spot; otherwise as {@link #move}.
     *
     * @param degrees to the left positive
     * @param cruiseDegPerSec the highest rate
     */
    public Value turn(double degrees, double cruiseDegPerSec, Motion motion) {
        return prepare(motion, 0) ? velocities.turn(degrees, cruiseDegPerSec, motion) : Value.of(0, Unit.DEG);
    }

    /**
     * Begins a drive or changes its velocity; waits for nothing.
     *
     * @throws MotionFailed if the vehicle cannot be moved, or the drive has ended
     * @throws LinkLost if the connection has ended
     */
    public void drive(double mmPerSec, double degPerSec) {
        failUnlessDrivable();
        arming.failUnlessArmed();
        boolean goesOn = droveNanos != 0 && time.secondsSince(droveNanos) < TAKEN_OVER_S;
        droveNanos = time.nanos();
        if (flies()) {
            flight.failIfEnded();
            flight.failUnlessFlying();
            if (!goesOn) {
                flight.failIfOutside(0, 0);
            }
        }
        mode.set();
        velocities.drive(mmPerSec, degPerSec);
    }

    /**
     * Makes the vehicle ready for a motion: armed, and in the mode GUIDED.
     *
     * @param mm how far it goes
     * @return false if the guard of the motion holds already
     * @throws MotionFailed if it cannot be moved
     */
    private boolean prepare(Motion motion, double mm) {
        failUnlessDrivable();
        if (!motion.pause(0)) {
            return false;
        }
        if (flies()) {
            return prepareFlight(motion, mm, 0);
        }
        if (!arming.isArmed() && owner.armsByMotion() && arming.arm(motion) != CommandOutcome.DONE) {
            return false;
        }
        arming.failUnlessArmed();
        return mode.enter(motion);
    }

    private boolean prepareFlight(Motion motion, double aheadMm, double upMm) {
        flight.failIfEnded();
        flight.failUnlessFlying();
        flight.failIfOutside(aheadMm, upMm);
        return mode.enter(motion);
    }

    /**
     * Takes off to a height above home; a copter that was armed by MAJIC, inside its fence.
     *
     * @param mm above home
     * @return the height
     * @throws MotionFailed if it may not, or something ended it
     */
    public Value takeOff(double mm, Motion motion) {
        failUnlessDrivable();
        flight.failUnlessGrounded(mm);
        flight.takingOff(true);
        try {
            flight.failIfEnded();
            if (!motion.pause(0) || !mode.enter(motion)) {
                return Value.of(flight.heightMm(), Unit.MM);
            }
            // A zero velocity that is still repeated after an earlier motion would end the take-off.
            motion.send(velocities::leave);
            return heightControl(motion).takeOff(mm, this::orderStop);
        } finally {
            flight.takingOff(false);
        }
    }

    /**
     * Changes the height of a copter in the air.
     *
     * @param mm up positive
     * @return the change
     * @throws MotionFailed if it may not, or something ended it
     */
    public Value climb(double mm, Motion motion) {
        failUnlessDrivable();
        if (!motion.pause(0) || !prepareFlight(motion, 0, mm)) {
            return Value.of(0, Unit.MM);
        }
        motion.send(velocities::leave);
        return heightControl(motion).climb(mm);
    }

    private HeightControl heightControl(Motion motion) {
        return new HeightControl(session, flight, new Base().obstructions(), targets, velocities::halt, motion, time);
    }

    private void failUnlessDrivable() {
        if (!session.vehicle().isMoved()) {
            throw new MotionFailed(
                    "it is a " + session.vehicle().title() + "; MAJIC moves only rovers, boats and copters by motions");
        }
        if (session.modes().guided().isEmpty()) {
            throw new MotionFailed("MAJIC does not drive vehicles of its autopilot, only those of ArduPilot");
        }
    }

    /** Arms the vehicle; as {@link Arming#arm}. */
    public CommandOutcome arm(Motion motion) {
        return arming.arm(motion);
    }

    /** Disarms the vehicle; as {@link Arming#disarm}. */
    public CommandOutcome disarm(Motion motion) {
        return arming.disarm(motion);
    }

    /**
     * Sets a mode that the user has named, and waits until it is shown. That of the stop is set also when the guard of
     * the motion holds already.
     *
     * @param name one of the modes of the vehicle
     * @throws MotionFailed if the autopilot refuses it
     */
    public CommandOutcome setMode(String name, Motion motion) {
        long number = session.modes().number(name).orElseThrow(() -> new BotException("there is no mode " + name));
        boolean stops = session.modes().stop().stream().anyMatch(mode -> mode == number);
        if (!motion.pause(0) && !stops) {
            return CommandOutcome.NOT_SENT;
        }
        motion.send(() -> {
            stop.cancel();
            stop.otherModeSent();
            mode.release();
        });
        boolean sent = session.commands()
                .run(
                        motion,
                        "change its mode to " + name,
                        MavlinkRequests.SET_MODE,
                        session.modes().arguments(number));
        boolean shown = sent && motion.await(() -> session.newestHeartbeat().customMode() == number, 3);
        if (!shown && motion.guardReached()) {
            return CommandOutcome.UNCONFIRMED;
        }
        if (!shown) {
            throw new MotionFailed("the autopilot accepts " + name + ", but its heartbeats show "
                    + session.modes().name(session.newestHeartbeat().customMode()));
        }
        return CommandOutcome.DONE;
    }

    /**
     * Sends a vehicle on the surface to a place by its own navigation, until it is there.
     *
     * @throws MotionFailed if it does not arrive
     */
    public String goToGlobal(int latitudeE7, int longitudeE7, Motion motion) {
        return prepare(motion, 0)
                ? new GlobalCourse(session, mode, time, latitudeE7, longitudeE7).run(motion, this::orderStop)
                : "not begun: the condition holds already";
    }

    /**
     * Writes the stop ahead of everything else; on any thread, waits for nothing but the link. A command whose permit
     * was checked before may still follow, so the next {@link #halt} writes it again.
     */
    public void haltAhead() {
        stopDue = true;
        orderStop();
    }

    private void orderStop() {
        mode.stopped();
        stop.order();
    }

    /** Ends what moves the vehicle: by the stop if one was ordered, otherwise by a zero velocity. */
    public void halt() {
        if (stopDue) {
            stopDue = false;
            orderStop();
        }
        if (session.vehicle().isMoved()) {
            velocities.halt();
        }
    }

    /** Whether MAJIC moves the vehicle, or has left it in a mode in which it may move. */
    public boolean isHeld() {
        return mode.isHeld();
    }

    /**
     * Waits until the vehicle has stopped: the mode of the stop is shown, and it is stationary.
     *
     * @throws BotException if it is not confirmed in time
     */
    public void confirmHalt() {
        boolean ordered = stop.isOrdered();
        stop.confirm(owner.name(), owner.waiting());
        if (ordered && (!arming.isArmed() || session.vehicle() == VehicleClass.BOAT)) {
            return;
        }
        if (session.vehicle().isOnSurface()) {
            velocities.confirmHalt();
        } else if (ordered) {
            awaitRest();
        } else if (flies() && velocities.hasReported()) {
            velocities.confirmHalt();
        }
    }

    private void awaitRest() {
        if (WaitPolicy.isAllowed() && !owner.waiting().await(this::isAtRest, REST_S)) {
            throw new BotException(owner.name() + " is in "
                    + session.modes().name(session.newestHeartbeat().customMode())
                    + ", but has not come to rest within " + Value.plain(REST_S) + " s");
        }
    }

    /** A vehicle that reports no velocity cannot be found moving. */
    private boolean isAtRest() {
        return session.hasEnded()
                || session.reports()
                        .newest(LocalPosition.class, 1)
                        .map(position -> 1000
                                * Math.hypot(
                                        Math.hypot(position.northMPerSec(), position.eastMPerSec()),
                                        position.downMPerSec()))
                        .filter(speed -> !(speed < RESTING_MM_PER_SEC))
                        .isEmpty();
    }

    /** Whether a vehicle on the surface moves. */
    public boolean isMovingOnSurface() {
        return session.vehicle().isOnSurface() && isMoving();
    }

    /** Where the vehicle is, as published last; empty if that is not of this moment. */
    public Optional<Pose> poseNow() {
        LastOdometry now = velocities.last();
        return time.secondsSince(now.atNanos()) <= POSE_S ? Optional.of(now.pose()) : Optional.empty();
    }

    /** Whether the vehicle moves, or was sent a velocity that is in force. */
    public boolean isMoving() {
        return velocities.isMoving();
    }

    /** Ends in order, while there is still a connection. */
    public void close() {
        stop.finish(owner.waiting());
        if (session.vehicle().isOnSurface()) {
            velocities.close();
        } else {
            velocities.end();
        }
    }

    /** Ends all waiting: the connection has ended. */
    public void end() {
        mode.release();
        velocities.end();
    }

    /** What the vehicle does whose connection was lost, as the second half of a sentence; may be empty. */
    public String afterLoss() {
        return session.vehicle().isOnSurface() || flies() && mode.isHeld() && velocities.isMoving()
                ? velocities.afterLoss()
                : "; what it does now is up to its autopilot: " + FailsafeText.of(session);
    }

    /** The driver as the control of velocities uses it. */
    private final class Base implements BaseOwner {
        @Override
        public String name() {
            return owner.name();
        }

        @Override
        public RobotWait waiting() {
            return owner.waiting();
        }

        @Override
        public ObstructionSource obstructions() {
            return () -> {
                Obstruction found = flies() ? flight.newest() : null;
                return found == null ? mode.newest() : found;
            };
        }

        @Override
        public double roundTripS() {
            return 0;
        }

        @Override
        public void once(String what, double seconds, Runnable task) {
            owner.once(what, seconds, task);
        }

        @Override
        public void every(String what, double seconds, Runnable task) {
            throw new IllegalStateException("only a base without odometry needs it");
        }

        @Override
        public void publish(BotState state) {
            owner.publish(state);
        }

        @Override
        public void notice(String message) {
            owner.notice(message);
        }
    }
}
