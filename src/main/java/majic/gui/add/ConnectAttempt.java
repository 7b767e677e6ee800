package majic.gui.add;

import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicReference;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.gui.kit.EventThread;
import majic.script.Session;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/**
 * Makes one attempt to connect a robot and add it to the team, in the background. A robot that has lost its connection
 * is reconnected under its existing number, as {@code add} does. The attempt ends in one of three ways; after
 * {@link #cancel()} it reports nothing more.
 */
final class ConnectAttempt {
    private enum Phase {
        CONNECTING,
        JOINING,
        CANCELLED
    }

    /** Receives the result of the attempt, on the event dispatch thread. */
    interface Outcome {
        /**
         * Reports that the robot is in the team and connected.
         *
         * @param member the robot's entry in the team
         */
        void joined(Member member);

        /**
         * Reports that the robot is not connected. A new robot is closed and not in the team; a robot that had lost its
         * connection stays in the team unchanged.
         *
         * @param reason why; its message is one sentence
         */
        void failed(BotException reason);
    }

    private final Session session;
    private final String address;
    private final Outcome outcome;
    private final AtomicReference<Phase> phase = new AtomicReference<>(Phase.CONNECTING);
    private volatile @Nullable MajicBot bot;

    ConnectAttempt(Session session, String address, Outcome outcome) {
        this.session = session;
        this.address = address;
        this.outcome = outcome;
    }

    void start() {
        EventThread.background("connecting " + address, this::run, why -> fail(new BotException(why)));
    }

    /**
     * Cancels the attempt; returns at once. Does not close a robot that is in the team: its driver stops trying at its
     * own timeout.
     */
    void cancel() {
        MajicBot begun = bot;
        if (phase.compareAndSet(Phase.CONNECTING, Phase.CANCELLED) && begun != null) {
            EventThread.background("cancelling " + address, begun::close);
        }
    }

    private void run() {
        try {
            Optional<Member> lost = session.lostAt(address);
            if (lost.isPresent()) {
                rejoin(lost.get());
            } else {
                joinNew();
            }
        } catch (BotException e) {
            fail(e);
        }
    }

    private void rejoin(Member member) {
        member.bot().connect();
        if (phase.compareAndSet(Phase.CONNECTING, Phase.JOINING)) {
            EventThread.later(() -> outcome.joined(member));
        }
    }

    private void joinNew() {
        session.team().checkRoom(OptionalInt.empty());
        session.checkUnused(address);
        MajicBot made = session.factory().create(address);
        bot = made;
        join(made);
    }

    private void join(MajicBot made) {
        try {
            made.connect();
            if (phase.compareAndSet(Phase.CONNECTING, Phase.JOINING)) {
                Member member = session.team().add(made, OptionalInt.empty());
                session.joined(member, address);
                EventThread.later(() -> outcome.joined(member));
            } else {
                made.close();
            }
        } catch (RuntimeException | Error e) {
            made.close();
            throw e;
        }
    }

    private void fail(BotException e) {
        if (phase.get() != Phase.CANCELLED) {
            EventThread.later(() -> outcome.failed(e));
        }
    }
}
