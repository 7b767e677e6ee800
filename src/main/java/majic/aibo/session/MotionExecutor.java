package majic.aibo.session;

import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.function.UnaryOperator;
import majic.aibo.body.DogState;
import majic.aibo.body.GaitPiece;
import majic.aibo.body.Stride;
import majic.aibo.urbi.AiboConnections;
import majic.aibo.urbi.Tags;
import majic.aibo.urbi.UrbiCommands;
import majic.aibo.urbi.UrbiConnection;
import majic.aibo.urbi.UrbiRequest;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.MotionFailed;
import majic.driver.DeadReckoning;
import majic.driver.Motion;
import majic.driver.RobotWait;
import org.jspecify.annotations.Nullable;

/**
 * Runs one motion command at a time and confirms its end. A stop is sent on the stop connection at once; whether it
 * arrived after the command that it stops is checked afterwards, see {@link RunningMotion#continueStop}. Thread-safe.
 */
public final class MotionExecutor {
    /** The failure of a motion that was stopped because of {@link MessageRouter#silence}. */
    static final String STOPPED = "no new reading came from the dog; MAJIC stopped it";

    private static final double CONFIRM_S = 5;
    private static final double AGAIN_S = 0.1;

    /** Long enough to confirm a stop with an engine that answers 2 s late. */
    private static final double FREE_S = 5;

    private final AiboConnections connections;
    private final Tags tags;
    private final RobotWait waiting;
    private final DogState dog;
    private final Runnable whenOver;
    private final AtomicReference<@Nullable RunningMotion> current = new AtomicReference<>();

    /** Calls the last argument when a motion has ended, on the thread that detects it. */
    MotionExecutor(AiboConnections connections, Tags tags, RobotWait waiting, DogState dog, Runnable whenOver) {
        this.connections = connections;
        this.tags = tags;
        this.waiting = waiting;
        this.dog = dog;
        this.whenOver = whenOver;
    }

    /** Returns the motion under way; null if none. */
    public @Nullable RunningMotion current() {
        return current.get();
    }

    /** Makes a piece of a gait, to be started. */
    RunningMotion piece(Stride stride, double amount) {
        UrbiRequest ask = ask();
        GaitPiece piece = new GaitPiece(stride, amount, ask);
        String commands = dog.legSpeed().order(stride) + " " + ask.tag() + "+begin+end: " + piece.call() + ",";
        return new RunningMotion(connections.motion(), ask, commands, piece);
    }

    /** Makes any other command that ends by itself, to be started. */
    public RunningMotion command(UrbiConnection on, String commands) {
        return command(on, tag -> commands);
    }

    /**
     * Makes a command that ends by itself out of several. A command inside a block does not have the block's tag (URBI
     * sheet 7), so a command there that may fail needs the tag itself.
     */
    RunningMotion command(UrbiConnection on, UnaryOperator<String> commandsForTag) {
        UrbiRequest ask = ask();
        return new RunningMotion(on, ask, ask.tag() + "+end: " + commandsForTag.apply(ask.tag()) + ",", null);
    }

    private UrbiRequest ask() {
        return new UrbiRequest(tags.next(), UrbiRequest.Expects.END, this::clear);
    }

    /** Starts it, if the condition still holds once it is the current motion; returns whether it was started. */
    boolean start(RunningMotion running, BooleanSupplier condition) {
        if (!makeCurrent(running)) {
            throw new BotException("the dog has not yet ended what it did before");
        }
        if (!condition.getAsBoolean()) {
            current.compareAndSet(running, null);
            return false;
        }
        GaitPiece piece = running.piece();
        if (piece != null) {
            dog.reckoning().begin(piece, Long.MAX_VALUE);
        }
        running.start();
        return true;
    }

    /** Clears an ended motion first: the next one may be started before that was done. */
    private synchronized boolean makeCurrent(RunningMotion running) {
        dropEnded();
        return current.compareAndSet(null, running);
    }

    private synchronized boolean dropEnded() {
        RunningMotion ended = current.get();
        if (ended == null || !ended.isOver()) {
            return false;
        }
        dog.reckoning().begin(DeadReckoning.Segment.STATIONARY, Long.MAX_VALUE);
        return current.compareAndSet(ended, null);
    }

    /** Called when a motion has ended, on the thread that detected it. */
    private void clear() {
        if (dropEnded()) {
            whenOver.run();
        }
        waiting.changes().raise();
    }

    /**
     * Waits until the dog has ended what it did before a motion.
     *
     * @throws MotionFailed if it does not end in time
     */
    public void awaitFree(Motion motion) {
        motion.check();
        if (!waiting.await(() -> current.get() == null, FREE_S)) {
            throw new MotionFailed("the dog has not ended what it did before");
        }
        motion.check();
    }

    /** Runs one command to its end, regardless of guard conditions: a dog must not stay half risen. */
    public void perform(Motion motion, RunningMotion running, double seconds) {
        motion.send(() -> start(running, () -> true));
        BooleanSupplier over = () -> running.isOver() || !mayContinue(motion);
        boolean ended = waiting.await(over, seconds);
        motion.check();
        if (!ended) {
            running.requestStop();
            throw new MotionFailed("the dog did not end it within " + (int) seconds + " s");
        }
        String failure = running.failure();
        if (failure != null) {
            throw new MotionFailed("the dog refuses: " + failure);
        }
        if (running.isStopRequested()) {
            throw new MotionFailed(STOPPED);
        }
    }

    private static boolean mayContinue(Motion motion) {
        try {
            motion.check();
            return true;
        } catch (BotException e) {
            return false;
        }
    }

    /** Sends the stop; does not wait for anything. */
    void halt(String further) {
        RunningMotion running = current.get();
        if (running == null) {
            connections.stop().send(UrbiCommands.STOP_GAITS + further);
        } else {
            running.requestStop();
            if (running.piece() == null) {
                dog.setStanding(false);
            }
            connections.stop().send(UrbiCommands.STOP_GAITS + running.stopCommands() + further);
        }
    }

    /** Waits until the dog has executed the stop and what it was doing has ended. */
    public void confirm() {
        RunningMotion running = current.get();
        UrbiRequest pong = connections.stop().ping(tags);
        BooleanSupplier stopped =
                () -> pong.isDone() && (running == null || running.isOver() || !running.isStopRequested());
        long started = waiting.time().nanos();
        while (!waiting.await(stopped, AGAIN_S)) {
            if (connections.stop().isEnded()) {
                throw new LinkLost("the stop was sent, but the connection was lost before the dog confirmed it");
            }
            if (waiting.time().secondsSince(started) > CONFIRM_S) {
                throw new BotException(
                        "the stop was sent, but the dog has not confirmed it within " + (int) CONFIRM_S + " s");
            }
            repeatStop();
        }
    }

    /** Repeats the stop until the stopped motion has ended; to be called periodically. */
    void repeatStop() {
        RunningMotion running = current.get();
        if (running != null && running.isStopRequested()) {
            running.continueStop(connections.stop(), tags, UrbiCommands.STOP_GAITS);
        }
    }

    /** Ends the current motion, since the connection is lost and no end will be reported. */
    void abandon() {
        RunningMotion running = current.get();
        if (running != null) {
            running.abandon("connection lost", dog.sensedMs());
        }
    }
}
