package majic.hemisson.readings;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import majic.driver.LastTimes;
import majic.hemisson.line.Question;
import majic.hemisson.line.Reply;
import majic.time.TimeSource;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * The last answers of the robot to the questions that are polled, and which questions are polled on request.
 * Thread-safe.
 */
public final class PolledAnswers {
    /** A requested question that is not requested again for this time is no longer polled, seconds. */
    private static final double REQUEST_S = 3;

    private final Map<String, Answer> answers = Collections.synchronizedMap(new Newest());
    private final TimeSource time;
    private final LastTimes<PolledQuestion> requests;
    private final Set<String> refusals = ConcurrentHashMap.newKeySet();
    private volatile @Nullable Proximity proximity;

    /** Holds nothing yet; times are on the given clock. */
    public PolledAnswers(TimeSource time) {
        this.time = time;
        this.requests = new LastTimes<>(time);
    }

    /** An answer and when it was asked for: what it reports was measured later. */
    public record Answer(Reply reply, long nanos) {}

    /**
     * The answers used last, because raw questions may be new each time; in the order of use, so that common ones stay.
     */
    private static final class Newest extends LinkedHashMap<String, Answer> {
        private static final long serialVersionUID = 1;
        private static final int MOST = 100;
        private static final float USUAL_LOAD = 0.75f;

        Newest() {
            super(MOST, USUAL_LOAD, true);
        }

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Answer> eldest) {
            return size() > MOST;
        }
    }

    /** Records an answer to a question that was sent at this time. */
    public void answered(Question question, Reply reply, long askedNanos) {
        answers.put(question.text(), new Answer(reply, askedNanos));
        if (question.equals(Question.PROXIMITY)) {
            Proximity before = proximity;
            proximity = before == null ? new Proximity(reply.numbers()) : before.next(reply.numbers());
        }
    }

    /** The latest proximity readings; null before the first. */
    public @Nullable Proximity proximity() {
        return proximity;
    }

    /** The last answer to a question; null before the first. */
    public @Nullable Answer answer(Question question) {
        return answers.get(question.text());
    }

    /** The last answer to a question, if it is not older than so; else null. */
    @Nullable
    Reply last(Question question, long ageNanos) {
        Answer last = answers.get(question.text());
        return last == null || time.nanos() - last.nanos() > ageNanos ? null : last.reply();
    }

    /** Whether the robot has ever answered it since the connection began. */
    boolean hasAnswered(Question question) {
        return answers.containsKey(question.text());
    }

    /** Records that the robot refused a question, unless it has answered it before: the line may have garbled it. */
    public void refused(Question question) {
        if (!hasAnswered(question)) {
            refusals.add(question.text());
        }
    }

    /** Whether the robot has refused it and never answered it. */
    boolean isRefused(Question question) {
        return refusals.contains(question.text());
    }

    /** Polls a question for the next seconds, unless the thread only observes. */
    void request(PolledQuestion question) {
        if (!WaitPolicy.isObserving()) {
            requests.record(question);
        }
    }

    /** The questions that are polled on request now. */
    List<PolledQuestion> requested() {
        return requests.within(REQUEST_S);
    }

    /** Clears everything, for a new connection. */
    public void forget() {
        answers.clear();
        requests.clear();
        refusals.clear();
        proximity = null;
    }
}
