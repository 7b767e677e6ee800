package majic.shared;

import java.util.function.Supplier;
import majic.bot.Unit;
import majic.bot.Value;
import majic.shared.message.RequestedAction;
import org.jspecify.annotations.Nullable;

/**
 * The time from a request to a shared robot to its answer, measured every few seconds. Used by the robot's timer
 * thread.
 */
final class DelayMeter {
    private static final double PERIOD_S = 5;
    private static final double SLOW_S = 0.3;
    private static final int SLOW_ANSWERS = 2;

    private final Supplier<RobotCommands> commands;
    private volatile @Nullable PendingReply probe;
    private volatile Value delay = Value.unknown("not measured yet");
    private int slow;
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
        if (last != null && last.ageS() < PERIOD_S) {
            take(last);
            return null;
        }
        probe = commands.get().request(new RequestedAction.Get("moving"));
        if (last == null) {
            return null;
        }
        commands.get().forget(last);
        return warning(last.answerS());
    }

    private void take(PendingReply answer) {
        if (answer.isAnswered()) {
            delay = Value.of(Math.round(answer.answerS() * 1000), Unit.MS);
        }
    }

    /** The first answers of a program that has just been started are slow by themselves, so that one is not enough. */
    private @Nullable String warning(double seconds) {
        slow = seconds > SLOW_S ? slow + 1 : 0;
        if (warned || slow < SLOW_ANSWERS) {
            return null;
        }
        warned = true;
        return "the answers of its desk take more than " + Math.round(SLOW_S * 1000)
                + " ms: commands and stops take as long, and readings are as old";
    }

    /** Returns half of the delay, which a report of the robot is on its way, ns; 0 before the first answer. */
    long oneWayNanos() {
        return delay instanceof Value.Number number ? Math.round(number.amount() * 1e6 / 2) : 0;
    }

    /** Returns the delay in ms; unknown before the first answer. */
    Value delay() {
        return delay;
    }
}
