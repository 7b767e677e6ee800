package majic.hemisson.line;

import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import majic.bot.BotException;
import majic.driver.RobotWait;
import org.jspecify.annotations.Nullable;

/**
 * Connects (Hemisson sheet 11): waits for a quiet line, ends a command that an earlier program left incomplete, asks
 * for firmware and mode, stops the robot. Moves nothing.
 */
public final class Handshake {
    private static final double LONGEST_GREETING_S = 1;

    private final HemissonSession session;
    private final HandshakeErrors errors;
    private final RobotWait waiting;

    public Handshake(HemissonSession session, RobotWait waiting) {
        this.session = session;
        this.errors = new HandshakeErrors(session);
        this.waiting = waiting;
    }

    /**
     * Runs on the thread that connects, which it blocks.
     *
     * @return the robot that answered
     * @throws BotException if no Hemisson answers; the message gives remedies
     */
    public Identity run() {
        waitForQuiet();
        refuseDeadLine();
        ask(Question.NOTHING);
        Reply version = ask(Question.VERSION);
        refuseDeadLine();
        if (version == null) {
            throw errors.noVersion();
        }
        Reply switches = ask(Question.SWITCHES);
        Reply speeds = ask(Question.SPEEDS);
        Identity identity =
                new Identity(version.rest(), switches == null ? List.of() : switches.numbers(), speeds != null);
        stop(identity, speeds);
        readFirst(identity);
        return identity;
    }

    /**
     * Asks the polled questions once, and tests whether the robot ignores the arguments of a stop behind a question.
     */
    private void readFirst(Identity identity) {
        Stream.of(Question.PROXIMITY, Question.LIGHT, Question.REMOTE).forEach(this::ask);
        if (identity.listens() && !identity.isRoadNarrows()) {
            boolean ignoresArguments = ask(Question.CARRYING_A_STOP) != null;
            session.conversation().receiver(ignoresArguments ? ReceiverLimits.K_TEAM : ReceiverLimits.UNKNOWN);
        }
    }

    /**
     * The answer about what is plugged in, of a robot that {@link #run} has stopped; null from firmware before 1.41.
     */
    public @Nullable Reply scan() {
        return ask(Question.MODULES);
    }

    /**
     * Stops the robot. One started in an unknown mode would be deafened by a long command; its motors are off anyway.
     * One whose running mode moves it gets a single stop, because the mode overrides it (sheet 7).
     */
    private void stop(Identity identity, @Nullable Reply speeds) {
        boolean speedsAreZero = speeds != null && speeds.numbers().stream().allMatch(speed -> speed == 0);
        session.conversation().setDeafenable(speedsAreZero && !identity.listens());
        session.conversation().setOwnSpeeds(identity.hasOwnSpeeds());
        if (speedsAreZero && !identity.listens()) {
            return;
        }
        if (identity.isRemoteControlled()) {
            stopAndConfirm();
        } else {
            ask(Question.STAND_ONCE);
        }
    }

    private void stopAndConfirm() {
        session.conversation().stop();
        if (!await(() -> session.conversation().isStopped())) {
            throw errors.noStop(timeoutSeconds());
        }
    }

    private void waitForQuiet() {
        waiting.awaitConnecting(() -> session.conversation().isQuiet(), LineRecovery.QUIET_NANOS / 1e9);
        double waited = 0;
        while (!session.conversation().isQuiet() && waited < LONGEST_GREETING_S) {
            waited += LineRecovery.QUIET_NANOS / 1e9;
            waiting.awaitConnecting(() -> session.conversation().isQuiet(), LineRecovery.QUIET_NANOS / 1e9);
        }
    }

    private void refuseDeadLine() {
        if (session.isClosed()) {
            throw errors.closed();
        }
        if (session.firstBytes().isTelnet()) {
            throw errors.telnet();
        }
    }

    /** Asks again if the robot was switched on in between. */
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
        return waiting.awaitConnecting(
                () -> condition.getAsBoolean()
                        || session.isClosed()
                        || session.firstBytes().isTelnet(),
                timeoutSeconds());
    }

    /** Long enough for both tries and the pause between them, seconds. */
    private double timeoutSeconds() {
        return 3 * session.timeoutSeconds() + 0.5;
    }
}
