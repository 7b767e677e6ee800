package majic.driver;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Supplier;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.Course;
import majic.bot.Guard;
import majic.bot.LinkLost;
import majic.bot.MotionFailed;
import majic.bot.MotionReport;
import majic.bot.MotionStopped;
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

    /**
     * A timed drive that is renewed later than this fails, seconds: the program was suspended, and a robot that its own
     * watchdog has stopped meanwhile must not move again by itself.
     */
    private static final double LATEST_RENEWAL_S = 1.5;

    private final MovingRobot bot;
    private final RobotTimer timer;
    private final Object commandLock = new Object();
    private final AtomicBoolean motionUnderWay = new AtomicBoolean();
    private volatile boolean driving;
    private Permit current = new Permit();
    private boolean latched;
    private boolean closed;

    /** What a motion does between its beginning and its end. */
    @FunctionalInterface
    interface Maneuver {
        @Nullable
        Value run(Motion motion);
    }

    MotionGate(MovingRobot bot, RobotTimer timer) {
        this.bot = bot;
        this.timer = timer;
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
            return watching(until, () -> {
                motion.check();
                Value amount = DriverCode.<@Nullable Value>call(bot, () -> maneuver.run(motion));
                return new MotionReport(amount, motion.seconds());
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

    MotionReport drive(double mmPerSec, double degPerSec, double seconds, Guard until, Permit permit) {
        return perform(until, permit, motion -> bot.driveFor(mmPerSec, degPerSec, seconds, motion));
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
        return perform(until, permit, motion -> new Following(course, motion).toTheEnd());
    }

    /** One motion by a course: the robot gets a speed when it is another one, and again before its drive would end. */
    private final class Following {
        private final Course course;
        private final Motion motion;
        private Course.Drive sent = Course.Drive.STAND;
        private double sentS;
        private double askedS;

        Following(Course course, Motion motion) {
            this.course = course;
            this.motion = motion;
        }

        @Nullable
        Value toTheEnd() {
            motion.pause(0);
            while (!motion.guardReached()) {
                Course.Step step = course.next();
                if (step instanceof Course.Arrived there) {
                    stand();
                    return there.amount();
                }
                take(step);
            }
            stand();
            return course.amount();
        }

        private void take(Course.Step step) {
            if (step instanceof Course.Turn turn) {
                stand();
                bot.turnBy(turn.degrees(), motion);
                askedS = motion.seconds();
            } else if (step instanceof Course.Drive drive) {
                drive(drive);
                motion.pause(Course.PERIOD_S);
            }
        }

        private void drive(Course.Drive asked) {
            double lastS = askedS;
            askedS = motion.seconds();
            refuseLateRenewal(askedS - lastS);
            Course.Drive now = new Course.Drive(
                    bot.profile().speed().clamp(asked.mmPerSec()),
                    bot.profile().turn().clamp(asked.degPerSec()));
            if (now.equals(Course.Drive.STAND)) {
                stand();
            } else if (!now.equals(sent) || askedS - sentS >= DRIVE_RENEWAL_S) {
                motion.send(() -> {
                    refuseLateRenewal(motion.seconds() - lastS);
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

    private void halt(Motion motion) {
        motion.send(bot::halt);
        try {
            bot.confirmHalt();
        } finally {
            // A stop that came meanwhile is the reason, whatever became of the confirmation.
            motion.check();
        }
    }

    private static void refuseLateRenewal(double afterS) {
        if (afterS > LATEST_RENEWAL_S) {
            throw new MotionFailed("this program stood still for " + Math.round(afterS) + " s; the drive ended");
        }
    }

    void drive(double mmPerSec, double degPerSec, Permit permit) {
        refuseInMotion();
        if (mmPerSec == 0 && degPerSec == 0) {
            endDrive();
            return;
        }
        send(permit, () -> {
            refuseInMotion();
            driving = true;
            timer.once("drive lapse", BotControl.DRIVE_LEASE_S, this::endDrive);
            bot.driveAt(mmPerSec, degPerSec);
        });
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
