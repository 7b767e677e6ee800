package majic.hemisson;

import org.jspecify.annotations.Nullable;

/** One question on its way to the robot, and what became of it. Changed by the conversation only; read by any thread. */
final class Exchange {
    private final Question question;
    private volatile int sendings;
    private volatile long sentNanos;
    private volatile long answeredNanos;
    private volatile @Nullable Reply reply;
    private volatile @Nullable String failure;

    Exchange(Question question) {
        this.question = question;
    }

    Question question() {
        return question;
    }

    Question.Purpose purpose() {
        return question.purpose();
    }

    void sent(long nowNanos) {
        sentNanos = nowNanos;
        sendings = sendings + 1;
    }

    void answered(Reply answer, long nowNanos) {
        answeredNanos = nowNanos;
        reply = answer;
    }

    void failed(String why) {
        failure = why;
    }

    /** How often it was sent so far. */
    int sendings() {
        return sendings;
    }

    long sentNanos() {
        return sentNanos;
    }

    boolean isDone() {
        return reply != null || failure != null;
    }

    /** The answer; null before it came and when none will. */
    @Nullable
    Reply reply() {
        return reply;
    }

    /** Why there will be no answer, as half a sentence; null unless that is so. */
    @Nullable
    String failure() {
        return failure;
    }

    /** From sending to answer, ns; only when answered. */
    long roundTripNanos() {
        return answeredNanos - sentNanos;
    }

    /** The likeliest moment at which the robot did it: half way between sending and answer. */
    long middleNanos() {
        return sentNanos + roundTripNanos() / 2;
    }
}
