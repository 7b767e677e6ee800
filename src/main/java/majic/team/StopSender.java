package majic.team;

import java.util.Collection;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import majic.bot.MajicBot.Connection;

/** Writes stops to robots, and passes on whether each robot has confirmed its stop. Thread-safe. */
final class StopSender {
    private final StopReceipts receipts;
    private final TeamEvents events;
    private final OverdueStops overdue;
    private final AtomicInteger open = new AtomicInteger();

    StopSender(TeamEvents events, StopReceipts receipts) {
        this.events = events;
        this.receipts = receipts;
        this.overdue = new OverdueStops(events, receipts);
    }

    /** Whether every stop that a robot has confirmed was answered. */
    boolean areAnswered() {
        return open.get() == 0;
    }

    /**
     * Writes on a thread of its own for each connection, so that a blocked one does not delay the others. If no thread
     * can be created, the calling thread writes to all those connections before it waits for a confirmation.
     *
     * @param latches whether it is a STOP
     */
    void send(Collection<Member> members, boolean latches) {
        long stop = receipts.begin(members, latches);
        StopAnswers answers = new StopAnswers(events, open, members);
        Runnable watch = overdue.watch(members, stop);
        List<Member> left = members.stream()
                .filter(member -> !member.time()
                        .tryRunAsync(
                                "stopping robot " + member.number(),
                                () -> write(member, stop, answers).run()))
                .toList();
        List<Runnable> confirmations =
                left.stream().map(member -> write(member, stop, answers)).toList();
        watch.run();
        confirmations.forEach(Runnable::run);
    }

    /**
     * Stops a robot again that is connected again and has not confirmed its last stop, which ends the alarm. Answers
     * nothing; returns at once.
     */
    void regained(Member member) {
        if (receipts.status().problem(member.number()).isPresent()) {
            member.time().tryRunAsync("stopping robot " + member.number() + " again", () -> stopAgain(member));
        }
    }

    private void stopAgain(Member member) {
        long stop = receipts.begin(List.of(member), false);
        try {
            if (member.driver().writeStop()) {
                member.driver().confirmHalt();
            }
            receipts.confirmed(member, stop);
        } catch (RuntimeException | Error e) {
            receipts.failed(member, stop, String.valueOf(e.getMessage()));
        }
        receipts.publish();
    }

    /** Writes a stop; the returned task waits for its confirmation and reports it. */
    private Runnable write(Member member, long stop, StopAnswers answers) {
        try {
            boolean written = member.driver().writeStop();
            return () -> confirm(member, stop, answers, () -> {
                if (written) {
                    member.driver().confirmHalt();
                }
            });
        } catch (RuntimeException | Error e) {
            return () -> confirm(member, stop, answers, () -> {
                throw e;
            });
        }
    }

    /** A robot that is not connected stays in every later stop, until it is removed or connected again. */
    private static String reason(Member member, Throwable e) {
        String reason = String.valueOf(e.getMessage());
        return member.bot().connection() == Connection.LOST
                ? reason + "; if it is at rest, \"remove " + member.number()
                        + "\" ends this alarm; \"add ADDRESS as " + member.number()
                        + "\" connects it under another address"
                : reason;
    }

    private void confirm(Member member, long stop, StopAnswers answers, Runnable confirmation) {
        try {
            confirmation.run();
            receipts.confirmed(member, stop);
            answers.confirmed(member);
        } catch (RuntimeException | Error e) {
            receipts.failed(member, stop, reason(member, e));
            answers.failed(member, reason(member, e));
        } finally {
            member.endStop();
        }
        receipts.publish();
    }
}
