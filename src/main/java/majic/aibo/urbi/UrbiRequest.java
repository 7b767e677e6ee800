package majic.aibo.urbi;

import org.jspecify.annotations.Nullable;

/**
 * A command that waits for an answer, and the answer. Set by the reader thread of its connection; read by any thread.
 */
public final class UrbiRequest {
    /** What makes a command answered. */
    public enum Expects {
        /** The first value under its tag. */
        VALUE,
        /** {@code *** end}, which a server sends when the command ended by itself (URBI sheet 7). */
        END,
        /** {@code *** pong}. */
        PONG
    }

    private final String tag;
    private final Expects expects;
    private final Runnable whenDone;
    private volatile @Nullable UrbiValue value;
    private volatile @Nullable String failure;
    private volatile long beganMs = -1;
    private volatile long doneMs = -1;
    private volatile boolean done;

    public UrbiRequest(String tag, Expects expects) {
        this(tag, expects, () -> {});
    }

    /**
     * A command whose end is reported.
     *
     * @param whenDone called by the reader's thread, once
     */
    public UrbiRequest(String tag, Expects expects, Runnable whenDone) {
        this.tag = tag;
        this.expects = expects;
        this.whenDone = whenDone;
    }

    public String tag() {
        return tag;
    }

    boolean expectsPong() {
        return expects == Expects.PONG;
    }

    /** Records a message with its tag. */
    void accept(UrbiMessage message) {
        if (message.body() instanceof UrbiMessage.Failure wrong) {
            fail(wrong.text(), message.timeMs());
        } else if (message.body() instanceof UrbiMessage.Info info) {
            acceptInfo(info.text(), message.timeMs());
        } else if (message.body() instanceof UrbiMessage.Result result) {
            acceptValue(result.value(), message.timeMs());
        }
    }

    private void acceptValue(UrbiValue answer, long timeMs) {
        value = answer;
        if (expects == Expects.VALUE) {
            finish(timeMs);
        }
    }

    private void acceptInfo(String text, long timeMs) {
        if (text.equals("begin")) {
            beganMs = timeMs;
        } else if (expects == Expects.END && text.equals("end") || expects == Expects.PONG && text.startsWith("pong")) {
            finish(timeMs);
        }
    }

    /** Ends it with a failure. */
    public void fail(String reason, long timeMs) {
        failure = reason;
        finish(timeMs);
    }

    /** Ends it without an answer: a command that was stopped by its tag sends no end. */
    public void finish(long timeMs) {
        synchronized (this) {
            if (done) {
                return;
            }
            doneMs = timeMs;
            done = true;
        }
        whenDone.run();
    }

    public boolean isDone() {
        return done;
    }

    /** The last value under its tag; a command whose end is expected may send one before. */
    public @Nullable UrbiValue value() {
        return value;
    }

    /** The error that the server reported; null if none. */
    public @Nullable String failure() {
        return failure;
    }

    /** When the server began with it, by its own clock in ms; −1 before. */
    public long beganMs() {
        return beganMs;
    }

    /** When it ended, by the server's clock in ms; −1 before. */
    public long doneMs() {
        return doneMs;
    }
}
