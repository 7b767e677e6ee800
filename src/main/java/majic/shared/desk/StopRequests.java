package majic.shared.desk;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import majic.shared.message.RequestReply;
import majic.shared.message.RequestReply.Outcome;
import majic.shared.message.StopMessage;
import majic.team.Member;
import majic.team.Owner;
import org.jspecify.annotations.Nullable;

/**
 * Carries out the stops of one robot that arrive from the broker, each at once on a thread of its own, and answers each
 * when the robot has confirmed it. When many arrive together, some of them share one stop that begins after all of
 * them. Thread-safe.
 */
final class StopRequests {
    private static final int MOST_AT_ONCE = 4;
    private static final int MOST_KNOWN = 50;

    /** Longer than a driver waits for the confirmation, seconds. */
    private static final double CONFIRMATION_S = 7;

    private final DeskContext desk;
    private final Member member;
    private final Runnable stateFirst;
    private final Deque<Stop> known = new ArrayDeque<>();
    private final List<Stop> waiting = new ArrayList<>();
    private final List<Stop> written = new ArrayList<>();
    private int writing;
    private boolean confirming;

    /** One stop, of which two copies may arrive. */
    private static final class Stop {
        final StopMessage message;
        final @Nullable Owner by;
        final Consumer<StopMessage> whenWritten;
        final List<Consumer<RequestReply>> receivers = new ArrayList<>();

        @Nullable
        RequestReply reply;

        Stop(StopMessage message, @Nullable Owner by, Consumer<StopMessage> whenWritten) {
            this.message = message;
            this.by = by;
            this.whenWritten = whenWritten;
        }
    }

    /** @param stateFirst publishes the state of the robot, which its readers need before the answer */
    StopRequests(DeskContext desk, Member member, Runnable stateFirst) {
        this.desk = desk;
        this.member = member;
        this.stateFirst = stateFirst;
    }

    /**
     * Stops the robot; returns at once.
     *
     * @param receiver receives the answer, when the robot has confirmed the stop or failed to; must not wait
     * @param by the owner that is not ended by it; null to end every owner
     * @param whenWritten called when the stop was written, before it is confirmed
     */
    void stop(
            StopMessage message,
            Consumer<RequestReply> receiver,
            @Nullable Owner by,
            Consumer<StopMessage> whenWritten) {
        Optional<Stop> before;
        synchronized (this) {
            before = find(message);
            before.ifPresent(stop -> stop.receivers.add(receiver));
            if (before.isEmpty()) {
                Stop stop = new Stop(message, by, whenWritten);
                stop.receivers.add(receiver);
                keep(stop);
                waiting.add(stop);
                if (writing >= MOST_AT_ONCE) {
                    return;
                }
                writing++;
            }
        }
        if (before.isEmpty()) {
            desk.connection().time().runAsync("stop of robot " + member.number() + " from the broker", this::run);
        } else if (before.get().reply != null) {
            receiver.accept(before.get().reply);
        }
    }

    private Optional<Stop> find(StopMessage message) {
        return known.stream()
                .filter(stop -> !message.id().isEmpty()
                        && stop.message.id().equals(message.id())
                        && stop.message
                                .sender()
                                .session()
                                .equals(message.sender().session()))
                .findFirst();
    }

    private void keep(Stop stop) {
        known.addLast(stop);
        if (known.size() > MOST_KNOWN) {
            known.removeFirst();
        }
    }

    private void run() {
        List<Stop> mine = takeWaiting();
        while (!mine.isEmpty()) {
            write(mine);
            mine = takeWaiting();
        }
        confirm();
    }

    private synchronized List<Stop> takeWaiting() {
        List<Stop> taken = List.copyOf(waiting);
        waiting.clear();
        if (taken.isEmpty()) {
            writing--;
        }
        return taken;
    }

    /** If stops of several sources are carried out together, none of them keeps its owner. */
    private void write(List<Stop> stops) {
        Owner by = stops.stream().allMatch(stop -> stop.by == stops.get(0).by) ? stops.get(0).by : null;
        try {
            desk.team().stop(List.of(member), by);
        } finally {
            stops.forEach(stop -> stop.whenWritten.accept(stop.message));
            synchronized (this) {
                written.addAll(stops);
            }
        }
    }

    /** One thread waits for the confirmation of everything that was written. */
    private void confirm() {
        synchronized (this) {
            if (confirming || written.isEmpty()) {
                return;
            }
            confirming = true;
        }
        try {
            for (List<Stop> stops = takeWritten(); !stops.isEmpty(); stops = takeWritten()) {
                RequestReply reply = awaitConfirmation();
                stateFirst.run();
                stops.forEach(stop -> answer(stop, reply));
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private synchronized List<Stop> takeWritten() {
        List<Stop> taken = List.copyOf(written);
        written.clear();
        confirming = !taken.isEmpty();
        return taken;
    }

    private RequestReply awaitConfirmation() throws InterruptedException {
        boolean ended = desk.team().changes().await(() -> !member.isStopping(), CONFIRMATION_S);
        Optional<String> problem = desk.team().stopStatus().problem(member.number());
        if (problem.isPresent()) {
            return RequestReply.of(Outcome.FAILED, problem.get());
        }
        return ended
                ? RequestReply.done("")
                : RequestReply.of(Outcome.FAILED, "not confirmed within " + (int) CONFIRMATION_S + " s");
    }

    private void answer(Stop stop, RequestReply reply) {
        List<Consumer<RequestReply>> receivers;
        synchronized (this) {
            stop.reply = reply;
            receivers = List.copyOf(stop.receivers);
        }
        receivers.forEach(receiver -> receiver.accept(reply));
    }
}
