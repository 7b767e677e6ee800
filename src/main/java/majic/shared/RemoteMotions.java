package majic.shared;

import java.util.Objects;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.MotionFailed;
import majic.bot.MotionStopped;
import majic.driver.Motion;
import majic.driver.RobotWait;
import majic.shared.message.RequestReply;
import majic.shared.message.RequestedAction;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * Requests what a shared robot has to do, and waits for the answers of its desk. Keeps whether this program may have
 * set the robot in motion, so that it has to be stopped when a motion does not end as it should. Thread-safe.
 */
final class RemoteMotions {
    private static final double FIRST_ANSWER_S = 2;
    private static final double SETTLED_S = 1;

    /** Without limit: a request may wait in the robot's queue, and its loss ends the motion. */
    private static final double LONGEST_MOTION_S = 1e6;

    /** How long anything but a motion may take once it was accepted, s. */
    private static final double LAST_ANSWER_S = 30;

    private final Supplier<RobotCommands> commands;
    private final RobotWait waiting;
    private final RemoteStop stop;
    private final Remote remote;
    private volatile @Nullable PendingReply motion;
    private volatile @Nullable PendingReply drive;

    /** The robot as its desk reports it. */
    interface Remote {
        /** Returns the name of the desk in messages. */
        String desk();

        /** Returns whether the desk can evaluate a condition in MAJIC Script. */
        boolean canGuard(String until);

        /** Returns whether the robot moves. */
        boolean isMoving();
    }

    /**
     * Commands one robot.
     *
     * @param commands publish to it; throws a {@link BotException} while there is no connection
     * @param waiting is woken by answers and by the loss of the robot
     * @param stop stops it
     */
    RemoteMotions(Supplier<RobotCommands> commands, RobotWait waiting, RemoteStop stop, Remote remote) {
        this.commands = commands;
        this.waiting = waiting;
        this.stop = stop;
        this.remote = remote;
    }

    /**
     * Performs a motion. The desk evaluates its guard if it can, otherwise this program does.
     *
     * @param action makes the request from the condition that the desk evaluates, which may be empty
     * @return the last answer; null if a guard that is evaluated here has ended the motion, or prevented it
     */
    @Nullable
    RequestReply perform(Motion permitted, Function<String, RequestedAction> action) {
        String until = permitted.handOverGuard(remote::canGuard).orElse("");
        if (!permitted.pause(0)) {
            return null;
        }
        RobotCommands to = commands.get();
        AtomicReference<@Nullable PendingReply> sent = new AtomicReference<>();
        permitted.send(() -> {
            sent.set(to.request(action.apply(until)));
            motion = sent.get();
        });
        PendingReply asked = Objects.requireNonNull(sent.get());
        try {
            return await(permitted, asked);
        } finally {
            to.forget(asked);
        }
    }

    private @Nullable RequestReply await(Motion permitted, PendingReply asked) {
        if (!permitted.await(asked::isAnswered, FIRST_ANSWER_S) && !permitted.guardReached()) {
            throw new MotionFailed(remote.desk() + " does not answer");
        }
        if (!permitted.guardReached()) {
            permitted.await(asked::isDone, LONGEST_MOTION_S);
        }
        if (!asked.isDone()) {
            permitted.send(this::halt);
            stop.confirm();
        }
        permitted.await(() -> !remote.isMoving(), SETTLED_S);
        return permitted.guardReached() ? null : checked(asked.end());
    }

    /**
     * Asks for something that moves nothing. Does not wait on a thread that must not; the answer is empty then.
     *
     * @throws BotException if the desk refuses, fails, or does not answer
     */
    RequestReply ask(RequestedAction action) {
        PendingReply asked = commands.get().request(action);
        try {
            return WaitPolicy.isAllowed() ? awaitAnswer(asked, action) : RequestReply.done("");
        } finally {
            commands.get().forget(asked);
        }
    }

    /**
     * Asks for a picture of the camera. Blocks for some seconds at most.
     *
     * @return a JPEG file
     * @throws BotException if there is none; the message says why
     */
    byte[] picture() {
        PendingReply asked = commands.get().request(new RequestedAction.Picture());
        try {
            awaitAnswer(asked, new RequestedAction.Picture());
            byte[] jpeg = asked.picture();
            if (jpeg == null) {
                throw new BotException(remote.desk() + " has sent no picture");
            }
            return jpeg;
        } finally {
            commands.get().forget(asked);
        }
    }

    private RequestReply awaitAnswer(PendingReply asked, RequestedAction action) {
        if (!await(asked::isAnswered, FIRST_ANSWER_S)) {
            throw new BotException(remote.desk() + " does not answer");
        }
        if (!await(asked::isDone, LAST_ANSWER_S)) {
            throw new BotException(
                    action + ": " + remote.desk() + " has not done it within " + Math.round(LAST_ANSWER_S) + " s");
        }
        return checked(asked.end());
    }

    private boolean await(BooleanSupplier condition, double seconds) {
        RobotCommands to = commands.get();
        boolean there = waiting.await(() -> condition.getAsBoolean() || to.isOver(), seconds);
        if (there && !condition.getAsBoolean()) {
            throw new LinkLost("the connection to " + remote.desk() + " was lost");
        }
        return there;
    }

    /** Returns the answer of what was done; throws what became of it otherwise. */
    private static RequestReply checked(@Nullable RequestReply end) {
        if (end == null) {
            throw new BotException("there is no answer");
        }
        switch (end.outcome()) {
            case STOPPED -> throw new MotionStopped(end.message());
            case FAILED -> throw new MotionFailed(end.message());
            case LOST -> throw new LinkLost(end.message());
            case REFUSED -> throw new BotException(end.message());
            case ACCEPTED, DONE -> {}
        }
        return end;
    }

    /**
     * Publishes the speeds for the next 600 ms. Waits for nothing.
     *
     * @throws BotException if the desk has refused those before
     */
    void drive(double mmPerSec, double degPerSec) {
        PendingReply present = drive;
        if (present != null && present.isDone()) {
            endDrive();
            checked(present.end());
            present = null;
        }
        if (present == null) {
            present = commands.get().expectDrive();
            drive = present;
        }
        commands.get().drive(mmPerSec, degPerSec, present);
    }

    private void endDrive() {
        PendingReply present = drive;
        drive = null;
        if (present != null) {
            commands.get().forget(present);
        }
    }

    /** Returns whether this program may have set the robot in motion, and nothing has ended that. */
    boolean isActive() {
        return isOpen(motion) || isOpen(drive);
    }

    private static boolean isOpen(@Nullable PendingReply reply) {
        return reply != null && !reply.isDone();
    }

    /**
     * Stops the robot, if a stop was begun or this program may have set it in motion. Waits for nothing. Otherwise
     * another user may be moving the robot, which the end of a motion that was refused here must not stop.
     */
    void halt() {
        if (stop.isAhead() || isActive()) {
            motion = null;
            endDrive();
            stop.send();
        }
    }

    /** Forgets what was begun, after the connection was lost. */
    void reset() {
        motion = null;
        drive = null;
    }
}
