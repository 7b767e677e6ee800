package majic.hemisson.readings;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import majic.hemisson.line.Question;
import majic.hemisson.line.Reply;
import org.jspecify.annotations.Nullable;

/**
 * The last answers of the robot to the questions that are polled, and which questions are polled on request.
 * Thread-safe.
 */
public final class PolledAnswers {
    /** A requested question that is not requested again for this time is no longer polled, ns. */
    private static final long WISH_NANOS = 3_000_000_000L;

    private final Map<String, Heard> heard = Collections.synchronizedMap(new Newest());
    private final Map<PolledQuestion, Long> wishes = new ConcurrentHashMap<>();
    private final Set<String> refused = ConcurrentHashMap.newKeySet();
    private volatile @Nullable Proximity seen;

    /** An answer and when it came. */
    public record Heard(Reply reply, long nanos) {}

    /**
     * The answers used last, because raw questions may be new each time; in the order of use, so that common ones stay.
     */
    private static final class Newest extends LinkedHashMap<String, Heard> {
        private static final long serialVersionUID = 1;
        private static final int MOST = 100;
        private static final float USUAL_LOAD = 0.75f;

        Newest() {
            super(MOST, USUAL_LOAD, true);
        }

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Heard> eldest) {
            return size() > MOST;
        }
    }

    /** Records an answer. */
    public void take(Question question, Reply reply, long nowNanos) {
        heard.put(question.text(), new Heard(reply, nowNanos));
        if (question.equals(Question.PROXIMITY)) {
            Proximity before = seen;
            seen = before == null ? new Proximity(reply.numbers()) : before.next(reply.numbers());
        }
    }

    /** The latest proximity readings; null before the first. */
    public @Nullable Proximity seen() {
        return seen;
    }

    /** The last answer to a question; null before the first. */
    public @Nullable Heard heard(Question question) {
        return heard.get(question.text());
    }

    /** The last answer to a question, if it is not older than so; else null. */
    @Nullable
    Reply last(Question question, long nowNanos, long ageNanos) {
        Heard last = heard.get(question.text());
        return last == null || nowNanos - last.nanos() > ageNanos ? null : last.reply();
    }

    /** Whether the robot has ever answered it since the connection began. */
    boolean knows(Question question) {
        return heard.containsKey(question.text());
    }

    /** Records that the robot refused a question, unless it has answered it before: the line may have garbled it. */
    public void refuse(Question question) {
        if (!knows(question)) {
            refused.add(question.text());
        }
    }

    /** Whether the robot has refused it and never answered it. */
    boolean isRefused(Question question) {
        return refused.contains(question.text());
    }

    /** Polls a question for the next seconds. */
    void want(PolledQuestion look, long nowNanos) {
        wishes.put(look, nowNanos);
    }

    /** The questions that are polled on request now. */
    List<PolledQuestion> wanted(long nowNanos) {
        wishes.values().removeIf(sinceNanos -> nowNanos - sinceNanos > WISH_NANOS);
        return new ArrayList<>(wishes.keySet());
    }

    /** Clears everything, for a new connection. */
    public void forget() {
        heard.clear();
        wishes.clear();
        refused.clear();
        seen = null;
    }
}
