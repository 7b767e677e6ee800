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
import majic.driver.RobotWait;
import org.jspecify.annotations.Nullable;

/**
 * Runs one motion command at a time and confirms its end. A stop goes out on the stop connection at once, without looking at
 * anything; whether it has hit what it was meant for is found out afterwards, see {@link RunningMotion#pursue}. Thread-safe.
 */
public final class MotionExecutor {
    private static final double CONFIRM_S = 5;
    private static final double AGAIN_S = 0.1;

    private final AiboConnections connections;
    private final Tags tags;
    private final RobotWait waiting;
    private final DogState dog;
    private final Runnable whenOver;
    private final AtomicReference<@Nullable RunningMotion> current = new AtomicReference<>();

    /** Calls the last argument at each end, on the thread that notices it. */
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
     * Makes a command that ends by itself out of several. What stands inside of a block does not have the block's tag
     * (URBI sheet 7), so what may go wrong there is to be marked with it.
     */
    RunningMotion command(UrbiConnection on, UnaryOperator<String> commandsForTag) {
        UrbiRequest ask = ask();
        return new RunningMotion(on, ask, ask.tag() + "+end: " + commandsForTag.apply(ask.tag()) + ",", null);
    }

    private UrbiRequest ask() {
        return new UrbiRequest(tags.next(), UrbiRequest.Expects.END, this::clear);
    }

    /** Starts it, if it may still be started once it is the current motion. Returns whether it was started. */
    boolean start(RunningMotion running, BooleanSupplier mayStill) {
        if (!take(running)) {
            throw new BotException("the dog has not yet ended what it did before");
        }
        if (!mayStill.getAsBoolean()) {
            current.compareAndSet(running, null);
            return false;
        }
        GaitPiece piece = running.piece();
        if (piece != null) {
            dog.reckoning().begin(piece);
        }
        running.start();
        return true;
    }

    /** Clears an ended motion first: the next one may be started before that was done. */
    private synchronized boolean take(RunningMotion running) {
        dropEnded();
        return current.compareAndSet(null, running);
    }

    private synchronized boolean dropEnded() {
        RunningMotion ended = current.get();
        if (ended == null || !ended.isOver()) {
            return false;
        }
        dog.reckoning().end();
        return current.compareAndSet(ended, null);
    }

    /** Called when a motion has ended, on the thread that noticed it. */
    private void clear() {
        if (dropEnded()) {
            whenOver.run();
        }
        waiting.changes().raise();
    }

    /** Sends the stop; does not wait for anything. */
    void halt(String further) {
        RunningMotion running = current.get();
        if (running == null) {
            connections.stop().send(UrbiCommands.STOP_GAITS + further);
        } else {
            running.requestStop();
            if (running.piece() == null) {
                dog.setAfoot(false);
            }
            connections.stop().send(UrbiCommands.STOP_GAITS + running.stopCommands() + further);
        }
    }

    /** Waits until the dog has executed the stop and what it was doing has ended. */
    public void confirm() {
        RunningMotion running = current.get();
        UrbiRequest pong = connections.stop().ping(tags);
        BooleanSupplier stands =
                () -> pong.isDone() && (running == null || running.isOver() || !running.isStopRequested());
        long started = waiting.time().nanos();
        while (!waiting.await(stands, AGAIN_S)) {
            if (connections.stop().isEnded()) {
                throw new LinkLost("the stop was sent, but the connection was lost before the dog confirmed it");
            }
            if (waiting.time().secondsSince(started) > CONFIRM_S) {
                throw new BotException(
                        "the stop was sent, but the dog has not confirmed it within " + (int) CONFIRM_S + " s");
            }
            pursue();
        }
    }

    /** Goes on making sure that what was stopped ends; to be called now and then. */
    void pursue() {
        RunningMotion running = current.get();
        if (running != null && running.isStopRequested()) {
            running.pursue(connections.stop(), tags, UrbiCommands.STOP_GAITS);
        }
    }

    /** Ends the current motion, since the connection is lost and no end will be reported. */
    void abandon() {
        RunningMotion running = current.get();
        if (running != null) {
            running.abandon("connection lost");
        }
    }
}
