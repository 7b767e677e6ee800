package majic.hemisson.motion;

import java.util.Locale;
import majic.bot.MotionFailed;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.Motion;
import majic.hemisson.line.BlockingConversation;
import majic.hemisson.line.Conversation;
import majic.hemisson.line.CurrentSession;
import majic.hemisson.line.Exchange;
import majic.hemisson.line.MotorValues;
import majic.hemisson.line.Question;
import majic.hemisson.line.StopConfirmation;
import majic.hemisson.readings.Proximity;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * Runs motions without feedback: timed ones (Hemisson sheet 13), and drives until they expire. Thread-safe;
 * {@code MajicBot} runs one motion at a time.
 */
public final class MotionRunner {
    /** A motion that ends earlier or later than this counts as failed: the line delayed its stop, seconds. */
    private static final double TOLERANCE_S = 0.15;

    private final CurrentSession sessions;
    private final BlockingConversation answers;
    private final StopConfirmation stopConfirmation;
    private final RobotMonitor monitor;
    private final TimeSource time;
    private volatile MotorValues driven = MotorValues.STILL;

    public MotionRunner(
            CurrentSession sessions,
            BlockingConversation answers,
            StopConfirmation stopConfirmation,
            RobotMonitor monitor,
            TimeSource time) {
        this.sessions = sessions;
        this.answers = answers;
        this.stopConfirmation = stopConfirmation;
        this.monitor = monitor;
        this.time = time;
    }

    /**
     * Runs a timed motion, or the part of it that the guard allows; blocks until the stop at its end is confirmed.
     *
     * @return what it has covered, as the estimated pose has it
     * @throws MotionFailed if the robot missed an answer, disobeyed or was reset, or the stop came too late; it was
     *     stopped, and the message says what it has covered
     */
    public Value run(TimedMotion plan, Motion motion) {
        return new Run(plan, motion).run();
    }

    /**
     * Sets the wheels, and does not wait for the answer; the monitor stops a drive that is not renewed.
     *
     * @throws MotionFailed if the robot cannot be driven now; the message says why
     */
    public void drive(MotorValues wheels) {
        refuseOverridden();
        monitor.motion().drives(time.nanos());
        driven = wheels;
        failOn(conversation().ask(Question.wheels(wheels)).failure());
    }

    /**
     * What the wheels were set to by the last {@link #drive}, which has ended.
     *
     * @throws MotionFailed if something went wrong in it
     */
    public MotorValues driven() {
        failOn(monitor.motion().trouble());
        return driven;
    }

    /** Refuses to move a robot that has set its own speeds after a stop. */
    private void refuseOverridden() {
        String found = monitor.wheels().found();
        if (found != null && conversation().isOverridden()) {
            throw new MotionFailed(found);
        }
    }

    private Conversation conversation() {
        return sessions.conversation();
    }

    private static void failOn(@Nullable String trouble) {
        if (trouble != null) {
            throw new MotionFailed(trouble);
        }
    }

    private static long nanos(double seconds) {
        return (long) (seconds * 1e9);
    }

    /** One timed motion, on the thread that asked for it. */
    private final class Run {
        private final TimedMotion plan;
        private final Motion motion;
        private final MotionWatch watch = monitor.motion();
        private final PoseEstimator.Way before = monitor.pose().way();

        Run(TimedMotion plan, Motion motion) {
            this.plan = plan;
            this.motion = motion;
        }

        Value run() {
            if (plan.seconds() <= 0 || !isAllowedToBegin()) {
                return Value.about(0, plan.unit());
            }
            Exchange start = begin();
            long due = start.middleNanos() + nanos(plan.seconds()) - start.roundTripNanos() / 2;
            watch.ends(due);
            runUntil(start.middleNanos(), due);
            motion.send(stopConfirmation::send);
            stopConfirmation.confirm();
            double covered = covered();
            String trouble = watch.trouble();
            failAfter(covered, trouble == null ? untimely(start.middleNanos()) : trouble);
            return Value.about(covered, plan.unit());
        }

        private double covered() {
            PoseEstimator.Way now = monitor.pose().way();
            return plan.unit() == Unit.MM ? now.mm() - before.mm() : now.deg() - before.deg();
        }

        /** Why the motion has not ended when it should, as half a sentence; null if it has. */
        private @Nullable String untimely(long begunNanos) {
            double seconds = (monitor.pose().sinceNanos() - begunNanos) / 1e9;
            double lateS = seconds - plan.seconds();
            return motion.guardReached() || Math.abs(lateS) <= TOLERANCE_S
                    ? null
                    : String.format(
                            Locale.ROOT,
                            "the line is too slow for it: it lasted %.2f s instead of %.2f s",
                            seconds,
                            plan.seconds());
        }

        private void failAfter(double covered, @Nullable String trouble) {
            if (trouble != null) {
                throw new MotionFailed(trouble + ", after " + Value.about(Math.rint(covered), plan.unit()));
            }
        }

        /** Reads the sensors once more, so that a guard condition that holds already prevents the motion. */
        private boolean isAllowedToBegin() {
            refuseOverridden();
            Proximity before = monitor.proximity();
            Exchange poll = conversation().ask(Question.PROXIMITY);
            answers.await(() -> poll.failure() != null || (poll.isDone() && monitor.proximity() != before));
            motion.check();
            failOn(poll.failure());
            return motion.pause(0);
        }

        /** The motion counts from the answer, less half of what the exchange took. */
        private Exchange begin() {
            Exchange[] start = new Exchange[1];
            motion.send(() -> {
                watch.begins(time.nanos() + nanos(plan.seconds()));
                start[0] = conversation().ask(Question.wheels(plan.wheels()));
            });
            answers.await(start[0]::isDone);
            motion.check();
            failOn(start[0].failure());
            return start[0];
        }

        /** Lets the time pass, and eases the faster wheel at the end of each round. */
        private void runUntil(long begunNanos, long dueNanos) {
            long round = plan.rounds() == 0 ? 0 : (dueNanos - begunNanos) / plan.rounds();
            for (int count = 0; count < plan.rounds(); count++) {
                long roundNanos = begunNanos + count * round;
                if (count > 0) {
                    send(plan.wheels());
                }
                if (!waitUntil(roundNanos + (long) (round * (1 - plan.easedShare())))) {
                    return;
                }
                send(plan.eased());
                if (count < plan.rounds() - 1 && !waitUntil(roundNanos + round)) {
                    return;
                }
            }
            waitUntil(dueNanos);
        }

        private void send(MotorValues wheels) {
            motion.send(() -> conversation().ask(Question.wheels(wheels)));
        }

        /** Waits until a time; returns false if something ends the motion before. */
        private boolean waitUntil(long untilNanos) {
            boolean met = motion.await(() -> watch.trouble() != null, (untilNanos - time.nanos()) / 1e9);
            return !met && !motion.guardReached();
        }
    }
}
