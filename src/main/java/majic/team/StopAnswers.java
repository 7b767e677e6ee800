package majic.team;

import java.util.Collection;
import java.util.concurrent.atomic.AtomicInteger;
import majic.time.Signal;
import majic.time.TimeSource;

/**
 * Answers stops. {@code done} means that the robot has confirmed the stop and is free: the owner that the stop ended
 * has given it back, so that the next motion is accepted. Thread-safe.
 */
final class StopAnswers {
    /** Longer than an act that does not end keeps its robots, seconds of the system's clock. */
    private static final double BOUND_S = 2.5;

    private final TeamEvents events;
    private final TimeSource time;
    private final AtomicInteger open = new AtomicInteger();

    StopAnswers(TeamEvents events, TimeSource time) {
        this.events = events;
        this.time = time;
    }

    /** Whether all stops that were confirmed have been answered. */
    boolean areGiven() {
        return open.get() == 0;
    }

    /** Returns the order of the answers of robots that are stopped together. */
    StopAnswerOrder order(Collection<Member> stopped) {
        return new StopAnswerOrder(events, time, open, stopped);
    }

    /** Answers a stop that was not confirmed. */
    void failed(Member member, StopAnswerOrder order, String reason) {
        answer(member, order, Answer.Outcome.NOT_STOPPED, "failed: " + reason);
    }

    /**
     * Answers a confirmed stop: at once if the robot is free, otherwise on another thread as soon as it is, or after
     * {@value #BOUND_S} s. Returns at once.
     */
    void confirmed(Member member, StopAnswerOrder order) {
        if (!member.isOwnerRevoked()) {
            answer(member, order, Answer.Outcome.DONE, "done");
            return;
        }
        open.incrementAndGet();
        Deadline deadline = new Deadline();
        boolean begun = TimeSource.system().tryRunAsync("stop answer timeout", deadline::await)
                && member.time()
                        .tryRunAsync(
                                "answering the stop of robot " + member.number(), () -> await(member, order, deadline));
        if (!begun) {
            deadline.end();
            close(member, order);
        }
    }

    private void await(Member member, StopAnswerOrder order, Deadline deadline) {
        try {
            events.changes().await(() -> deadline.over || !member.isOwnerRevoked(), Signal.FOR_EVER);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            deadline.end();
            close(member, order);
        }
    }

    private void close(Member member, StopAnswerOrder order) {
        Owner owner = member.owner();
        try {
            if (owner == null || !owner.isRevoked()) {
                answer(member, order, Answer.Outcome.DONE, "done");
            } else {
                answer(
                        member,
                        order,
                        Answer.Outcome.FAILED,
                        "stopped, but " + owner.name() + " has not given the robot back");
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
                ended.await(() -> over, BOUND_S);
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

    private static void answer(Member member, StopAnswerOrder order, Answer.Outcome outcome, String how) {
        order.answer(new Answer(member.number(), outcome, member.number() + " stop: " + how));
    }
}
