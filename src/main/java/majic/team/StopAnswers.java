package majic.team;

import java.util.Collection;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.atomic.AtomicInteger;
import majic.time.Signal;
import majic.time.TimeSource;

/**
 * The answers of robots that are stopped together. {@code done} means that the robot has confirmed the stop and is
 * free: the owner that the stop revoked has given it back, so that the next motion is accepted. The answers are in the
 * order of the robots' numbers: one waits for those of lower numbers, for {@value #ORDER_S} s at most; the answer of a
 * robot that did not confirm the stop never waits. Thread-safe.
 */
final class StopAnswers {
    /** Longer than an act that does not end keeps its robots, seconds of the system's clock. */
    private static final double GIVEN_BACK_S = 2.5;

    /** Seconds; a robot that drives at the speed of an act has braked within about half of that. */
    private static final double ORDER_S = 2;

    private final TeamEvents events;
    private final AtomicInteger open;
    private final TreeSet<Integer> unanswered = new TreeSet<>();
    private final TreeMap<Integer, Answer> waiting = new TreeMap<>();
    private boolean timing;
    private boolean late;

    /**
     * No answer yet.
     *
     * @param open counts the confirmed stops that are not answered yet, among others
     */
    StopAnswers(TeamEvents events, AtomicInteger open, Collection<Member> stopped) {
        this.events = events;
        this.open = open;
        stopped.forEach(member -> unanswered.add(member.number()));
    }

    /** Answers a stop that was not confirmed. */
    void failed(Member member, String reason) {
        answer(member, Answer.Outcome.NOT_STOPPED, "failed: " + reason);
    }

    /**
     * Answers a confirmed stop: at once if the robot is free, otherwise on another thread as soon as it is, or after
     * {@value #GIVEN_BACK_S} s. Returns at once.
     */
    void confirmed(Member member) {
        if (!member.isOwnerRevoked()) {
            answer(member, Answer.Outcome.DONE, "done");
            return;
        }
        open.incrementAndGet();
        Deadline deadline = new Deadline();
        boolean begun = TimeSource.system().tryRunAsync("stop answer timeout", deadline::await)
                && member.time()
                        .tryRunAsync(
                                "answering the stop of robot " + member.number(), () -> awaitFree(member, deadline));
        if (!begun) {
            deadline.end();
            close(member);
        }
    }

    private void awaitFree(Member member, Deadline deadline) {
        try {
            events.changes().await(() -> deadline.over || !member.isOwnerRevoked(), Signal.FOR_EVER);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            deadline.end();
            close(member);
        }
    }

    private void close(Member member) {
        Owner owner = member.owner();
        try {
            if (owner == null || !owner.isRevoked()) {
                answer(member, Answer.Outcome.DONE, "done");
            } else {
                answer(member, Answer.Outcome.FAILED, "stopped, but " + owner.name() + " has not given the robot back");
            }
        } finally {
            open.decrementAndGet();
            events.changes().raise();
        }
    }

    /**
     * The end of the wait, on the system's clock, because a stepped clock passes 2 s at once while it waits for an act.
     */
    private final class Deadline {
        private final Signal ended = TimeSource.system().signal();
        private volatile boolean over;

        void await() {
            try {
                ended.await(() -> over, GIVEN_BACK_S);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
            over = true;
            events.changes().raise();
        }

        /** Ends the thread that waits, too. */
        void end() {
            over = true;
            ended.raise();
        }
    }

    /** Publishes an answer, and those that waited for it; keeps it if it has to wait. Returns at once. */
    private void answer(Member member, Answer.Outcome outcome, String how) {
        Answer answer = new Answer(member.number(), outcome, member.number() + " stop: " + how);
        if (add(answer) && !events.time().tryRunAsync("order of stop answers", this::timeOut)) {
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
            events.changes().await(this::isComplete, ORDER_S);
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
