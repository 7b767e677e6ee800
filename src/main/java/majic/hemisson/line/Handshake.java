package majic.hemisson.line;

import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import majic.bot.BotException;
import majic.time.Signal;
import org.jspecify.annotations.Nullable;

/**
 * How a connection begins (Hemisson sheet 11): wait for quiet, end what somebody else left half said, ask who is there
 * and in which mode it runs, tell it to stand. Moves nothing.
 */
public final class Handshake {
    private static final double LONGEST_GREETING_S = 1;

    private final HemissonSession session;
    private final Signal changes;

    public Handshake(HemissonSession session, Signal changes) {
        this.session = session;
        this.changes = changes;
    }

    /**
     * Goes through it, on the thread that connects.
     *
     * @return who answered
     * @throws BotException if nobody does, or not a Hemisson; with what to try
     */
    public Identity run() {
        waitForQuiet();
        refuseDeadLine();
        ask(Question.NOTHING);
        Reply version = ask(Question.VERSION);
        refuseDeadLine();
        if (version == null) {
            throw new BotException(
                    "no Hemisson answered, though asked twice; one that has gone deaf hears again when it was off: switch it off, wait 5 s, switch it on. "
                            + "Or is it another port, or the robot off, or in the Pgm position?");
        }
        Reply switches = ask(Question.SWITCHES);
        Reply speeds = ask(Question.SPEEDS);
        Identity identity =
                new Identity(version.rest(), switches == null ? List.of() : switches.numbers(), speeds != null);
        letStand(identity, speeds);
        readFirst(identity);
        return identity;
    }

    /** Everything that is watched from then on, and whether the robot takes a question that carries a stop. */
    private void readFirst(Identity identity) {
        Stream.of(Question.PROXIMITY, Question.LIGHT, Question.REMOTE).forEach(this::ask);
        if (identity.listens() && !identity.isRoadNarrows()) {
            boolean ignoresArguments = ask(Question.CARRYING_A_STOP) != null;
            session.conversation().receiver(ignoresArguments ? Receiver.K_TEAM : Receiver.UNKNOWN);
        }
    }

    /** The answer about what is plugged in, of a robot that {@link #run} has stopped; null from firmware before 1.41. */
    public @Nullable Reply scan() {
        return ask(Question.MODULES);
    }

    /**
     * A robot started in an unknown mode would be deafened by a long command; its motors are held anyway. One that runs a
     * behaviour of its own is told to stand once and will not keep to it (sheet 7).
     */
    private void letStand(Identity identity, @Nullable Reply speeds) {
        boolean held = speeds != null && speeds.numbers().stream().allMatch(speed -> speed == 0);
        session.conversation().brief(held && !identity.listens());
        session.conversation().setsItsOwnSpeeds(identity.setsItsOwnSpeeds());
        if (held && !identity.listens()) {
            return;
        }
        if (identity.isRemoteControlled()) {
            stop();
        } else {
            ask(Question.STAND_ONCE);
        }
    }

    private void stop() {
        session.conversation().stop();
        if (!await(() -> session.conversation().isStanding())) {
            throw new BotException("it answers, but does not confirm a stop within " + patience()
                    + " s; lift it, switch it off, wait 5 s and switch it on again");
        }
    }

    private void waitForQuiet() {
        await(() -> session.conversation().isQuiet(), LineRecovery.QUIET_NANOS / 1e9);
        double waited = 0;
        while (!session.conversation().isQuiet() && waited < LONGEST_GREETING_S) {
            waited += LineRecovery.QUIET_NANOS / 1e9;
            await(() -> session.conversation().isQuiet(), LineRecovery.QUIET_NANOS / 1e9);
        }
    }

    private void refuseDeadLine() {
        if (session.isClosed()) {
            String end = session.end();
            throw new BotException(end == null ? "closed while connecting" : "the connection was lost at once: " + end);
        }
        if (session.isTelnet()) {
            throw new BotException(
                    "what answers there speaks telnet (RFC 2217), not a raw serial line; can the serial server be set to "
                            + "raw TCP?");
        }
    }

    /** A robot that is switched on just now greets in between, and is asked again. */
    private @Nullable Reply ask(Question question) {
        Exchange exchange = askOnce(question);
        if (Exchange.RESET.equals(exchange.failure())) {
            waitForQuiet();
            exchange = askOnce(question);
        }
        return exchange.reply();
    }

    private Exchange askOnce(Question question) {
        Exchange exchange = session.conversation().ask(question);
        await(exchange::isDone);
        return exchange;
    }

    private boolean await(BooleanSupplier condition) {
        return await(() -> condition.getAsBoolean() || session.isClosed() || session.isTelnet(), patience());
    }

    /** Long enough for both tries and the quiet between them. */
    private double patience() {
        return 3 * session.timeoutSeconds() + 0.5;
    }

    private boolean await(BooleanSupplier condition, double seconds) {
        try {
            return changes.await(condition, seconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new BotException("connecting was interrupted");
        }
    }
}
