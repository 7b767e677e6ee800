package majic.gui.add;

import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicReference;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.gui.kit.Edt;
import majic.script.Session;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/**
 * One attempt to connect a robot and take it into the team, in the background; one that has lost its link is connected
 * again under the number it has, as {@code add} does. It ends in one of three ways, and after
 * {@link #cancel()} nothing more is heard of it.
 */
final class ConnectAttempt {
    private enum Phase {
        CONNECTING,
        JOINING,
        CANCELLED
    }

    /** Hears how the attempt ends, on the event dispatch thread. */
    interface Outcome {
        /**
         * The robot is in the team, connected.
         *
         * @param member as what
         */
        void joined(Member member);

        /**
         * The robot is not connected. A new one is not in the team either, and closed; a lost one stays there as it was.
         *
         * @param reason one sentence
         */
        void failed(String reason);
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
        Edt.background("connecting " + address, this::run);
    }

    /** Gives up; returns at once. A robot of the team is not closed by it: its driver gives up by itself. */
    void cancel() {
        MajicBot begun = bot;
        if (phase.compareAndSet(Phase.CONNECTING, Phase.CANCELLED) && begun != null) {
            Edt.background("giving up " + address, begun::close);
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
            Edt.later(() -> outcome.joined(member));
        }
    }

    private void joinNew() {
        session.team().checkRoom(OptionalInt.empty());
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
                Edt.later(() -> outcome.joined(member));
            } else {
                made.close();
            }
        } catch (BotException e) {
            made.close();
            throw e;
        }
    }

    private void fail(BotException e) {
        if (phase.get() != Phase.CANCELLED) {
            Edt.later(() -> outcome.failed(e.getMessage()));
        }
    }
}
