package majic.team;

import java.util.Collection;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.atomic.AtomicInteger;
import majic.time.TimeSource;

/**
 * Puts the answers of robots that are stopped together into the order of their numbers. An answer waits for those of
 * lower numbers, for {@value #BOUND_S} s at most; the answer of a robot that did not confirm the stop never waits.
 * Thread-safe.
 */
final class StopAnswerOrder {
    /** Seconds; a robot that drives at the speed of an act has braked within about half of that. */
    private static final double BOUND_S = 2;

    private final TeamEvents events;
    private final TimeSource time;
    private final AtomicInteger open;
    private final TreeSet<Integer> unanswered = new TreeSet<>();
    private final TreeMap<Integer, Answer> waiting = new TreeMap<>();
    private boolean timing;
    private boolean late;

    /**
     * Creates the order of one stop.
     *
     * @param open counts the answers that wait, among others
     */
    StopAnswerOrder(TeamEvents events, TimeSource time, AtomicInteger open, Collection<Member> stopped) {
        this.events = events;
        this.time = time;
        this.open = open;
        stopped.forEach(member -> unanswered.add(member.number()));
    }

    /** Publishes an answer, and those that waited for it; keeps it if it has to wait. Returns at once. */
    void answer(Answer answer) {
        if (add(answer) && !time.tryRunAsync("order of stop answers", this::timeOut)) {
            endWaiting();
        }
        events.deliver();
    }

    /** Returns whether the time limit has to be started. */
    private synchronized boolean add(Answer answer) {
        unanswered.remove(answer.robot());
        open.incrementAndGet();
        if (answer.outcome() == Answer.Outcome.NOT_STOPPED) {
            publish(answer);
        } else {
            waiting.put(answer.robot(), answer);
        }
        release();
        boolean start = !timing && !waiting.isEmpty();
        timing |= start;
        return start;
    }

    private void release() {
        while (!waiting.isEmpty() && (late || unanswered.isEmpty() || unanswered.first() > waiting.firstKey())) {
            publish(waiting.pollFirstEntry().getValue());
        }
    }

    private void publish(Answer answer) {
        events.put(listener -> listener.answered(answer), () -> {
            open.decrementAndGet();
            events.changes().raise();
        });
    }

    private void timeOut() {
        try {
            events.changes().await(this::isComplete, BOUND_S);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        endWaiting();
        events.deliver();
    }

    private synchronized boolean isComplete() {
        return unanswered.isEmpty();
    }

    private synchronized void endWaiting() {
        late = true;
        release();
    }
}
