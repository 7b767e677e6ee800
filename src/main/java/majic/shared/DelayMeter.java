package majic.shared;

import java.util.function.Supplier;
import majic.bot.Unit;
import majic.bot.Value;
import majic.shared.message.RequestedAction;
import org.jspecify.annotations.Nullable;

/** The time from a request to a shared robot to its answer, measured every few seconds. Used by the robot's timer thread. */
final class DelayMeter {
    private static final double PERIOD_S = 5;
    private static final double SLOW_S = 0.3;

    private final Supplier<RobotCommands> commands;
    private volatile @Nullable PendingReply probe;
    private volatile Value delay = Value.unknown("not measured yet");
    private boolean warned;

    /** Measures with requests to one robot. */
    DelayMeter(Supplier<RobotCommands> commands) {
        this.commands = commands;
    }

    /** Begins to measure anew, after a connection was made. */
    void begin() {
        probe = null;
        delay = Value.unknown("not measured yet");
    }

    /**
     * Takes the answer of the last request, and asks again when it is time. Called a few times a second.
     *
     * @return a warning for the user; null if there is none
     */
    @Nullable
    String tick() {
        PendingReply last = probe;
        if (last == null) {
            probe = commands.get().request(new RequestedAction.Get("moving"));
            return null;
        }
        if (last.isAnswered()) {
            delay = Value.of(Math.round(last.answerS() * 1000), Unit.MS);
        }
        String warning = warning(last.answerS());
        if (last.ageS() >= PERIOD_S) {
            commands.get().forget(last);
            probe = commands.get().request(new RequestedAction.Get("moving"));
        }
        return warning;
    }

    private @Nullable String warning(double seconds) {
        if (warned || seconds <= SLOW_S) {
            return null;
        }
        warned = true;
        return "the answers of its desk take more than " + Math.round(SLOW_S * 1000)
                + " ms: it is commanded with this delay, and guards are evaluated at its desk";
    }

    /** Returns the delay in ms; unknown before the first answer. */
    Value delay() {
        return delay;
    }
}
