package majic.driver;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.Course;
import majic.bot.Guard;
import majic.bot.LinkLost;
import majic.bot.MotionFailed;
import majic.bot.MotionReport;
import majic.bot.MotionStopped;
import majic.bot.Pose;
import majic.bot.Unit;
import majic.bot.Value;
import majic.time.Signal;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * Serialises everything that moves one robot: motions, drives that expire unless renewed, and stops, which overtake
 * both. Each command that moves the robot is sent under one lock, together with a check of the permit. A thread that
 * holds it must not wait, least of all for a listener. Thread-safe.
 */
final class MotionGate {
    private static final Logger LOG = System.getLogger(MotionGate.class.getName());

    /** How often a timed drive renews itself, seconds. */
    private static final double DRIVE_RENEWAL_S = 0.3;

    /** How long a guarded motion waits for its first reading, seconds. */
    private static final double FIRST_READING_S = 1.5;

    private final MovingRobot bot;
    private final RobotTimer timer;
    private final GuardedDriving guarding;
    private final Object commandLock = new Object();
    private final AtomicBoolean motionUnderWay = new AtomicBoolean();
    private volatile boolean driving;

    /** The guarded drive in progress; null for one that is not guarded. */
    private volatile @Nullable GuardedDrive guarded;

    private Permit current = new Permit();
    private boolean latched;
    private boolean closed;

    /** What a motion does between its beginning and its end. */
    @FunctionalInterface
    interface Maneuver {
        @Nullable
        Value run(Motion motion);
    }

    /** A drive in front of which something may come; the share of its speeds was sent last. */
    private record GuardedDrive(double mmPerSec, double degPerSec, Permit permit, double share) {
        GuardedDrive at(double newShare) {
            return new GuardedDrive(mmPerSec, degPerSec, permit, newShare);
        }
    }

    MotionGate(MovingRobot bot, RobotTimer timer, GuardedDriving guarding) {
        this.bot = bot;
        this.timer = timer;
        this.guarding = guarding;
    }

    /** The permit in force: each stop, and the loss of the connection, revokes it and puts another in its place. */
    synchronized Permit permit() {
        return current;
    }

    /** Ends all motions begun under the present permit; later ones get a new one, unless latched. Does not block. */
    synchronized void revoke(Supplier<? extends BotException> reason) {
        current.revoke(reason);
        if (!latched) {
            current = new Permit();
        }
    }

    /** Ends all motions and permits no others until {@link #unlatch()}. Does not block. */
    synchronized void latch(Supplier<? extends BotException> reason) {
        if (closed) {
            return;
        }
        current.revoke(() -> new MotionStopped("stopped"));
        current = new Permit();
        current.revoke(reason);
        latched = true;
    }

    synchronized void unlatch() {
        if (latched && !closed) {
            latched = false;
            current = new Permit();
        }
    }

    /** As {@link #latch}, for good: {@link #unlatch()} does nothing any more. The first reason stays. */
    synchronized void close(Supplier<? extends BotException> reason) {
        if (!closed) {
            latch(reason);
            closed = true;
        }
    }

    boolean isDriving() {
        return driving;
    }

    boolean isBusy() {
        return driving || motionUnderWay.get();
    }

    /**
     * Performs a whole motion. If it ends early, this method sends the stop, unless the robot's own permit was revoked:
     * revoking that one sends a stop at once, while revoking only a caller's additional permit sends none. A caller
     * that receives {@link LinkLost} may connect again at once, though the reader may not have detected the end yet.
     */
    MotionReport perform(Guard until, Permit permit, Maneuver maneuver) {
        Objects.requireNonNull(until, "until");
        bot.requireConnected();
        Permit own = permit();
        begin(permit);
        Motion motion = new Motion(bot, this, until, permit);
        try {
            endDrive();
            locked(bot::motionBegins);
            return watching(until, () -> {
                motion.check();
                Value amount = DriverCode.<@Nullable Value>call(bot, () -> maneuver.run(motion));
                return new MotionReport(amount, motion.wholeSeconds());
            });
        } catch (LinkLost e) {
            // A permit may have been revoked because another robot's link was lost.
            if (!permit.isRevoked()) {
                bot.lost(e);
            }
            throw e;
        } catch (RuntimeException | Error e) {
            if (!permit.isRevoked() || (motion.hasSent() && !own.isRevoked())) {
                haltIfConnected();
            }
            throw e;
        } finally {
            motionUnderWay.set(false);
            bot.changes().raise();
        }
    }

    /**
     * Performs a motion that fails when guarded driving ends it, if that is on.
     *
     * @param ahead the direction, mm or mm/s; 0 on the spot
     * @param end begins to look for a reason to end it, when it begins
     */
    MotionReport guarded(
            Guard until, Permit permit, double ahead, Supplier<Supplier<@Nullable String>> end, Maneuver maneuver) {
        return perform(until, permit, motion -> {
            if (!isGuarded(motion)) {
                return maneuver.run(motion);
            }
            motion.endWhen(end.get());
            Value amount = maneuver.run(motion);
            failIfEnded(motion, amount, ahead);
            return amount;
        });
    }

    /** Waits for the first reading of a motion that is guarded. */
    private boolean isGuarded(Motion motion) {
        if (!bot.limits().isGuarded()) {
            return false;
        }
        if (!guarding.isPossible()) {
            motion.notice("guard: it has no sensors for it, and its place on a map is not known");
            return false;
        }
        double endS = motion.seconds() + FIRST_READING_S;
        while (guarding.isWaiting() && motion.seconds() < endS && !motion.guardReached()) {
            motion.pause(Course.PERIOD_S);
        }
        return true;
    }

    /** The message has the distance where the robot stands, unless nothing is in its way any more. */
    private void failIfEnded(Motion motion, @Nullable Value amount, double ahead) {
        String reason = motion.endedBecause();
        if (reason != null) {
            String now = guarding.obstacle(ahead);
            throw new MotionFailed("stopped after " + amount + ": " + (now.isEmpty() ? reason : now));
        }
    }

    MotionReport drive(double mmPerSec, double degPerSec, double seconds, Guard until, Permit permit) {
        return perform(until, permit, motion -> {
            if (!isGuarded(motion)) {
                return bot.driveFor(mmPerSec, degPerSec, seconds, motion);
            }
            Pose start = guarding.odometry();
            motion.endWhen(guarding.endOfDrive(mmPerSec, degPerSec));
            new Following(motion).reduced(mmPerSec, degPerSec, seconds);
            Value driven = bot.driven();
            double mm = Math.rint(start.distanceMm(guarding.odometry()));
            failIfEnded(motion, new Value.Number(mm, Unit.MM, bot.profile().estimates()), mmPerSec);
            return driven;
        });
    }

    /** Lets new readings of all other robots that the guard reads wake the motion. */
    private MotionReport watching(Guard until, Supplier<MotionReport> motion) {
        if (until == Guard.NEVER) {
            return motion.get();
        }
        List<? extends Guard.ReadingSource> others = until.alsoWatches();
        Runnable lookAgain = bot.readings()::lookAgain;
        others.forEach(other -> other.addWatcher(lookAgain));
        try {
            return motion.get();
        } finally {
            others.forEach(other -> other.removeWatcher(lookAgain));
        }
    }

    /** A motion that is not one after the other with those that move the robot: for what does not move it. */
    Motion beside(Permit permit) {
        return new Motion(bot, this, Guard.NEVER, permit);
    }

    /** Waits for the motion under way to end. */
    private void begin(Permit permit) {
        try {
            while (!motionUnderWay.compareAndSet(false, true)) {
                bot.changes().await(() -> !motionUnderWay.get() || permit.isRevoked(), Signal.FOR_EVER);
                permit.check();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new MotionStopped("interrupted");
        }
    }

    private void haltIfConnected() {
        try {
            if (bot.isConnected()) {
                locked(bot::halt);
            }
        } catch (BotException e) {
            LOG.log(Level.DEBUG, "could not halt " + bot.name(), e);
        }
    }

    /** Drives for a time by a command that is renewed, unless the guard holds already. */
    @Nullable
    Value driveRenewing(double mmPerSec, double degPerSec, double seconds, Motion motion) {
        if (!motion.pause(0)) {
            return null;
        }
        driveOn(mmPerSec, degPerSec, seconds, motion);
        return bot.driven();
    }

    private void driveOn(double mmPerSec, double degPerSec, double seconds, Motion motion) {
        double renewedS = motion.seconds();
        double endS = renewedS + seconds;
        while (motion.seconds() < endS && !motion.guardReached()) {
            double lastS = renewedS;
            motion.send(() -> {
                refuseLateRenewal(motion.seconds() - lastS);
                bot.driveAt(mmPerSec, degPerSec);
            });
            renewedS = motion.seconds();
            motion.pause(Math.min(DRIVE_RENEWAL_S, endS - motion.seconds()));
        }
        halt(motion);
    }

    MotionReport follow(Course course, Guard until, Permit permit) {
        Objects.requireNonNull(course, "course");
        return perform(until, permit, motion -> new Following(motion).toTheEnd(course));
    }

    /**
     * One motion with changing speeds: the robot gets a speed when it is another one, and again before its drive would
     * end.
     */
    private final class Following {
        private final Motion motion;
        private Course.Drive sent = Course.Drive.STAND;
        private double sentS;
        private double askedS;

        Following(Motion motion) {
            this.motion = motion;
        }

        void reduced(double mmPerSec, double degPerSec, double seconds) {
            askedS = motion.wholeSeconds();
            double endS = askedS + seconds;
            motion.pause(0);
            while (motion.wholeSeconds() < endS && !motion.guardReached()) {
                double share = guarding.share(mmPerSec, degPerSec);
                drive(new Course.Drive(share * mmPerSec, share * degPerSec));
                motion.pause(Math.min(Course.PERIOD_S, endS - motion.wholeSeconds()));
            }
            stand();
        }

        @Nullable
        Value toTheEnd(Course course) {
            motion.pause(0);
            while (!motion.guardReached()) {
                Course.Step step = course.next();
                if (step instanceof Course.Arrived there) {
                    stand();
                    return there.amount();
                }
                take(step, course);
            }
            stand();
            return course.amount();
        }

        private void take(Course.Step step, Course course) {
            if (step instanceof Course.Turn turn) {
                part(() -> bot.turnBy(turn.degrees(), motion), () -> false);
            } else if (step instanceof Course.Move move) {
                part(() -> bot.moveBy(move.mm(), motion), course::isBlocked);
            } else if (step instanceof Course.Drive drive) {
                drive(drive);
                motion.pause(Course.PERIOD_S);
            }
        }

        private void part(Runnable maneuver, BooleanSupplier isBlocked) {
            stand();
            motion.part(maneuver, isBlocked);
            askedS = motion.wholeSeconds();
        }

        private void drive(Course.Drive asked) {
            double lastS = askedS;
            askedS = motion.wholeSeconds();
            refuseLateRenewal(askedS - lastS);
            Course.Drive now = new Course.Drive(
                    bot.profile().speed().clamp(asked.mmPerSec()),
                    bot.profile().turn().clamp(asked.degPerSec()));
            if (now.equals(Course.Drive.STAND)) {
                stand();
            } else if (!now.equals(sent) || askedS - sentS >= DRIVE_RENEWAL_S) {
                motion.send(() -> {
                    refuseLateRenewal(motion.wholeSeconds() - lastS);
                    bot.driveAt(now.mmPerSec(), now.degPerSec());
                });
                sent = now;
                sentS = askedS;
            }
        }

        private void stand() {
            if (!sent.equals(Course.Drive.STAND)) {
                halt(motion);
                sent = Course.Drive.STAND;
            }
        }
    }

    /** Stops the robot at the end of a motion, and waits until that is confirmed. */
    void halt(Motion motion) {
        motion.send(bot::halt);
        try {
            bot.confirmHalt();
        } finally {
            // A stop that came meanwhile is the reason, whatever became of the confirmation.
            motion.check();
        }
    }

    private static void refuseLateRenewal(double afterS) {
        String late = RenewalWatch.late(afterS);
        if (late != null) {
            throw new MotionFailed(late + "; the drive ended");
        }
    }

    /** Returns the share of the speeds that was sent. */
    double drive(double mmPerSec, double degPerSec, boolean isGuarded, Permit permit) {
        refuseInMotion();
        if (mmPerSec == 0 && degPerSec == 0) {
            endDrive();
            return 1;
        }
        double share = isGuarded ? guarding.share(mmPerSec, degPerSec) : 1;
        send(permit, () -> {
            refuseInMotion();
            GuardedDrive before = guarded;
            boolean moves = driving && (before == null || before.share > 0);
            boolean begins = !driving;
            driving = true;
            if (begins) {
                bot.motionBegins();
            }
            guarded = isGuarded ? new GuardedDrive(mmPerSec, degPerSec, permit, share) : null;
            timer.once("drive lapse", BotControl.DRIVE_LEASE_S, this::endDrive);
            if (share > 0) {
                bot.driveAt(share * mmPerSec, share * degPerSec);
            } else if (moves) {
                bot.halt();
            }
        });
        return share;
    }

    boolean isGuarding() {
        return driving && guarded != null;
    }

    /** Adapts a guarded drive to new readings; on a thread that may be held up by that. */
    void guardAgain() {
        GuardedDrive drive = guarded;
        if (drive == null || !driving) {
            return;
        }
        double share = guarding.share(drive.mmPerSec, drive.degPerSec);
        if (share == drive.share) {
            return;
        }
        try {
            send(drive.permit, () -> {
                if (driving && guarded == drive) {
                    guarded = drive.at(share);
                    if (share > 0) {
                        bot.driveAt(share * drive.mmPerSec, share * drive.degPerSec);
                    } else {
                        bot.halt();
                    }
                }
            });
        } catch (BotException e) {
            LOG.log(Level.DEBUG, "a guarded drive of " + bot.name() + " ends", e);
        }
    }

    /** Returns why the guarded drive in progress is slower than it was requested; empty if it is not. */
    Optional<String> heldBack() {
        return isGuarding() ? guarding.reason() : Optional.empty();
    }

    /** Called again under the lock: a drive must not be sent into a motion that has begun meanwhile. */
    private void refuseInMotion() {
        if (motionUnderWay.get()) {
            throw new BotException(bot.name() + " is in a motion; stop it before driving");
        }
    }

    /**
     * Stops the robot if a drive is in progress, for example before a motion, which may turn out to have nothing to do.
     */
    private void endDrive() {
        locked(() -> {
            if (driving) {
                driving = false;
                bot.halt();
            }
        });
    }

    /** Sends what moves the robot. */
    void send(Permit permit, Runnable write) {
        locked(() -> {
            permit.check();
            bot.requireConnected();
            DriverCode.run(bot, write);
        });
    }

    private void locked(Runnable sending) {
        synchronized (commandLock) {
            WaitPolicy.without(sending);
        }
    }

    /**
     * Sends the stop to the robot. The early stop waits for nothing; the ordinary one waits for the lock and so follows
     * any command that was being sent under a permit that has been revoked meanwhile.
     */
    void writeStop() {
        WaitPolicy.without(this::haltAhead);
        locked(() -> {
            driving = false;
            bot.halt();
        });
    }

    /**
     * Sends the stop for good, behind what is being sent: nothing follows any more when all permits are revoked. Does
     * not wait until it is confirmed.
     *
     * @param connected whether there is a connection to write to
     */
    void end(boolean connected) {
        if (connected) {
            WaitPolicy.without(this::haltAhead);
        }
        locked(() -> {
            driving = false;
            if (connected) {
                haltQuietly();
            }
        });
    }

    private void haltQuietly() {
        try {
            bot.halt();
        } catch (RuntimeException | Error e) {
            LOG.log(Level.DEBUG, "could not halt " + bot.name(), e);
        }
    }

    private void haltAhead() {
        try {
            bot.haltAhead();
        } catch (RuntimeException e) {
            LOG.log(Level.DEBUG, "no early stop for " + bot.name(), e);
        }
    }

    /** Handles the loss of the connection: revokes every permission to move the robot. */
    void lost(LinkLost cause) {
        driving = false;
        revoke(() -> new LinkLost(cause.getMessage(), cause));
    }
}
