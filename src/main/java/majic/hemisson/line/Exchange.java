package majic.hemisson.line;

import org.jspecify.annotations.Nullable;

/** A question and its answer. Changed only by the conversation; read by any thread. */
public final class Exchange {
    /** The failure of a question that was discarded because the robot was switched on or reset. */
    static final String RESET = "the robot was reset";

    private final Question question;
    private volatile String text;
    private volatile int sendings;
    private volatile boolean written;
    private volatile boolean refused;
    private volatile long askedNanos;
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

    /** Whether it stops the robot or verifies that it is stopped. */
    boolean isOfStop() {
        return purpose() == Question.Purpose.STOP || purpose() == Question.Purpose.VERIFY;
    }

    /** Records that it is sent now in this wording. */
    void sent(String wording, long nowNanos) {
        text = wording;
        written = false;
        askedNanos = sendings == 0 ? nowNanos : askedNanos;
        sentNanos = nowNanos;
        sendings = sendings + 1;
    }

    /** What was sent, without its CR. */
    String text() {
        return text;
    }

    /** Records that it was written to the link; before that its answer cannot be overdue. */
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

    /** Records that the robot refused it. */
    void refused() {
        refused = true;
    }

    public boolean isRefused() {
        return refused;
    }

    /** How often it was sent. */
    int sendings() {
        return sendings;
    }

    long sentNanos() {
        return sentNanos;
    }

    /** Records that it repeats a stop, which was sent at this time and is not answered yet. */
    void repeats(long firstNanos) {
        askedNanos = firstNanos;
    }

    /** When it was sent for the first time: what the answer reports was measured later, ns. */
    public long askedNanos() {
        return askedNanos;
    }

    public boolean isDone() {
        return reply != null || failure != null;
    }

    /** The answer; null before it arrives, and if the exchange failed. */
    public @Nullable Reply reply() {
        return reply;
    }

    /** The cause of the failure, as half a sentence; null unless it failed. */
    public @Nullable String failure() {
        return failure;
    }

    /** From sending to answer, ns; only when answered. */
    public long roundTripNanos() {
        return answeredNanos - fromNanos();
    }

    /** The likeliest time of execution, ns: half way between sending and answer. */
    public long middleNanos() {
        return fromNanos() + roundTripNanos() / 2;
    }

    /** Stops are repeated before the first one can be answered, so an answer is that to the first. */
    private long fromNanos() {
        return purpose() == Question.Purpose.STOP ? askedNanos : sentNanos;
    }
}
