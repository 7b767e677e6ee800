package majic.aibo.session;

import majic.aibo.body.GaitPiece;
import majic.aibo.urbi.Tags;
import majic.aibo.urbi.UrbiConnection;
import majic.aibo.urbi.UrbiRequest;
import org.jspecify.annotations.Nullable;

/**
 * A command under way that moves the dog: a piece of a gait, a posture, a timed joint. There is never more than one.
 * Safe from any thread.
 */
public final class RunningMotion {
    private final UrbiConnection on;
    private final UrbiRequest ask;
    private final String commands;
    private final @Nullable GaitPiece piece;
    private volatile boolean stopRequested;
    private volatile boolean unknown;
    private boolean written;
    private @Nullable UrbiRequest arrival;
    private @Nullable UrbiRequest execution;

    /** A gait piece if there is one, otherwise any command with the ask's tag and the {@code +end} flag. */
    RunningMotion(UrbiConnection on, UrbiRequest ask, String commands, @Nullable GaitPiece piece) {
        this.on = on;
        this.ask = ask;
        this.commands = commands;
        this.piece = piece;
    }

    /** Marks it as a command whose effect on the dog is unknown. */
    public RunningMotion unknown() {
        unknown = true;
        return this;
    }

    /** Whether it can make the dog walk, so that the guard on the dog must be armed. */
    boolean mayWalk() {
        return piece != null || unknown;
    }

    /** Writes it to the dog, unless it was stopped before; then it ends at once. */
    synchronized void start() {
        if (stopRequested) {
            ask.finish(on.lastTimeMs());
        } else {
            written = true;
            on.send(ask, commands);
        }
    }

    /**
     * What ends it. A gait is stopped inside, by the stick's own tags, so that the caller's {@code *** end} still comes
     * and reports how long it has walked; a command stopped by its own tag sends none (URBI sheet 7, 15).
     */
    String stopCommands() {
        return piece == null ? "stop " + ask.tag() + "," : "";
    }

    void requestStop() {
        stopRequested = true;
    }

    boolean isStopRequested() {
        return stopRequested;
    }

    boolean isOver() {
        return ask.isDone();
    }

    public @Nullable GaitPiece piece() {
        return piece;
    }

    @Nullable
    String failure() {
        return ask.failure();
    }

    /**
     * Takes the next step to make sure that it has ended. The stop is sent on another connection and may overtake the
     * command that it stops. So a ping behind the command shows when the command has arrived; a stop sent after that
     * takes effect, and a ping behind this stop shows when.
     */
    synchronized void continueStop(UrbiConnection stopping, Tags tags, String stopAll) {
        if (isOver() || !written) {
            return;
        }
        if (arrival == null) {
            arrival = on.ping(tags);
        } else if (arrival.isDone() && execution == null) {
            stopping.send(stopAll + " stop " + ask.tag() + ",");
            execution = stopping.ping(tags);
        } else if (execution != null && execution.isDone()) {
            on.forget(ask);
            ask.finish(execution.doneMs());
        } else {
            stopping.send(stopAll + stopCommands());
        }
    }

    /** By the server's clock, when it ended, ms; −1 before. */
    long endedMs() {
        return ask.doneMs();
    }

    /**
     * Takes it as ended, regardless of later messages.
     *
     * @param knownMs until when it is known to have gone on, by the server's clock
     */
    void abandon(String reason, long knownMs) {
        on.forget(ask);
        ask.fail(reason, Math.max(knownMs, on.lastTimeMs()));
    }
}
