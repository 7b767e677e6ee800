package majic.shared;

import java.nio.charset.StandardCharsets;
import majic.driver.RobotWait;
import majic.shared.broker.BrokerMessage;
import majic.shared.message.RequestReply;
import majic.shared.message.RequestReply.Outcome;
import majic.shared.message.UnusableMessageException;
import org.jspecify.annotations.Nullable;

/** The answers to one request, as far as they have arrived. Thread-safe. */
final class PendingReply {
    private static final String PICTURE = "image/jpeg";

    private final String correlation;
    private final RobotWait waiting;
    private final long sentNanos;
    private volatile long answeredNanos;
    private volatile boolean answered;
    private volatile @Nullable RequestReply end;
    private volatile byte @Nullable [] picture;

    /**
     * No answer yet.
     *
     * @param correlation by which the answers are recognised
     * @param waiting is woken by each answer
     */
    PendingReply(String correlation, RobotWait waiting) {
        this.correlation = correlation;
        this.waiting = waiting;
        this.sentNanos = waiting.time().nanos();
    }

    String correlation() {
        return correlation;
    }

    byte[] correlationData() {
        return correlation.getBytes(StandardCharsets.UTF_8);
    }

    /** Takes an answer. */
    void received(BrokerMessage message) {
        if (message.contentType().equals(PICTURE)) {
            picture = message.payload();
            take(RequestReply.done(""));
            return;
        }
        try {
            take(RequestReply.parse(message.payload()));
        } catch (UnusableMessageException e) {
            take(RequestReply.of(Outcome.FAILED, String.valueOf(e.getMessage())));
        }
    }

    /** The broker has not taken the request. */
    void refused(String reason) {
        take(RequestReply.of(Outcome.REFUSED, reason));
    }

    private synchronized void take(RequestReply reply) {
        if (!answered) {
            answeredNanos = waiting.time().nanos();
            answered = true;
        }
        if (!reply.isFirst() && end == null) {
            end = reply;
        }
        waiting.changes().raise();
    }

    /** Returns whether the desk has answered at all. */
    boolean isAnswered() {
        return answered;
    }

    /** Returns whether the last answer is there. */
    boolean isDone() {
        return end != null;
    }

    /** Returns the last answer; null as long as it is missing. */
    @Nullable
    RequestReply end() {
        return end;
    }

    /** Returns the time from the request to its first answer, s; the time until now as long as there is none. */
    double answerS() {
        return answered ? (answeredNanos - sentNanos) / 1e9 : ageS();
    }

    /** Returns the time since the request, s. */
    double ageS() {
        return waiting.time().secondsSince(sentNanos);
    }

    /** Returns the file of the picture in the answer; null if there is none. */
    byte @Nullable [] picture() {
        return picture;
    }
}
