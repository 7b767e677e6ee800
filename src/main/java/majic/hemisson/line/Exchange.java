package majic.hemisson.line;

import org.jspecify.annotations.Nullable;

/** One question on its way to the robot, and what became of it. Changed by the conversation only; read by any thread. */
public final class Exchange {
    /** Why a question was forgotten that waited when the robot was switched on or reset. */
    static final String RESET = "the robot was reset";

    private final Question question;
    private volatile String text;
    private volatile int sendings;
    private volatile boolean written;
    private volatile boolean refused;
    private volatile long sentNanos;
    private volatile long answeredNanos;
    private volatile @Nullable Reply reply;
    private volatile @Nullable String failure;

    Exchange(Question question) {
        this.question = question;
        this.text = question.text();
    }

    public Question question() {
        return question;
    }

    public Question.Purpose purpose() {
        return question.purpose();
    }

    /** Whether it is one of those by which the robot is made to stand. */
    boolean isOfStop() {
        return purpose() == Question.Purpose.STOP || purpose() == Question.Purpose.VERIFY;
    }

    /** It goes out now, in these words. */
    void sent(String wording, long nowNanos) {
        text = wording;
        written = false;
        sentNanos = nowNanos;
        sendings = sendings + 1;
    }

    /** What was sent, without its CR. */
    String text() {
        return text;
    }

    /** It has left this side; before that no answer can be overdue. */
    void written() {
        written = true;
    }

    boolean isWritten() {
        return written;
    }

    void answered(Reply answer, long nowNanos) {
        answeredNanos = nowNanos;
        reply = answer;
    }

    void failed(String why) {
        failure = why;
    }

    /** Notes that the robot did not understand it. */
    void refused() {
        refused = true;
    }

    public boolean isRefused() {
        return refused;
    }

    /** How often it was sent so far. */
    int sendings() {
        return sendings;
    }

    long sentNanos() {
        return sentNanos;
    }

    public boolean isDone() {
        return reply != null || failure != null;
    }

    /** The answer; null before it came and when none will. */
    public @Nullable Reply reply() {
        return reply;
    }

    /** Why there will be no answer, as half a sentence; null unless that is so. */
    public @Nullable String failure() {
        return failure;
    }

    /** From sending to answer, ns; only when answered. */
    public long roundTripNanos() {
        return answeredNanos - sentNanos;
    }

    /** The likeliest moment at which the robot did it: half way between sending and answer. */
    public long middleNanos() {
        return sentNanos + roundTripNanos() / 2;
    }
}
