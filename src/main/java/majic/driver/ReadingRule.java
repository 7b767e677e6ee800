package majic.driver;

import java.util.function.DoubleSupplier;
import java.util.function.LongSupplier;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.Reading;
import majic.bot.Value;
import majic.time.WaitPolicy;

/** Reads the parameters of one robot, and decides by the rule of {@link Reading} whether they are current. */
final class ReadingRule {
    private static final double NANOS_PER_S = 1e9;

    private final MajicBot bot;
    private final RobotWait waiting;
    private final DoubleSupplier longestAgeS;

    /**
     * The rule for one robot.
     *
     * @param waiting its clock and signal
     * @param longestAgeS how old a reading may be while the robot is connected, s
     */
    ReadingRule(MajicBot bot, RobotWait waiting, DoubleSupplier longestAgeS) {
        this.bot = bot;
        this.waiting = waiting;
        this.longestAgeS = longestAgeS;
    }

    /**
     * Reads a parameter. While the robot is connected, a thread that may wait waits for the next report if the last one
     * is too old.
     *
     * @throws BotException what its reader throws, if the robot is connected
     */
    Reading read(ParameterTable.Entry entry) {
        if (entry.isKept()) {
            return Reading.current(DriverCode.call(bot, entry.reader()), Double.NaN);
        }
        if (bot.isConnected()) {
            awaitRecent(entry);
            Value value = ask(entry);
            if (bot.isConnected()) {
                return judged(entry, value);
            }
        }
        return outdated(entry, absence());
    }

    private void awaitRecent(ParameterTable.Entry entry) {
        double longestS = longestAgeS.getAsDouble();
        if (WaitPolicy.isAllowed() && ageOf(entry) > longestS) {
            waiting.await(() -> !bot.isConnected() || ageOf(entry) <= longestS, longestS);
        }
    }

    /** A reader may fail because the connection is lost meanwhile, which the caller checks. */
    private Value ask(ParameterTable.Entry entry) {
        try {
            return DriverCode.call(bot, entry.reader());
        } catch (BotException e) {
            if (bot.isConnected()) {
                throw e;
            }
            return Value.unknown(absence());
        }
    }

    private Reading judged(ParameterTable.Entry entry, Value value) {
        double ageS = ageOf(entry);
        return ageS > longestAgeS.getAsDouble()
                ? new Reading(value, ageS, "no recent report")
                : Reading.current(value, ageS);
    }

    /** Why no reading is current. */
    private String absence() {
        return switch (bot.connection()) {
            case NEW -> "not connected";
            case CONNECTING -> "being connected";
            case CONNECTED, LOST -> "connection lost";
            case CLOSED -> "closed";
        };
    }

    /** What was reported before the connection was lost; nothing is asked. */
    private Reading outdated(ParameterTable.Entry entry, String reason) {
        double ageS = ageOf(entry);
        Value[] last = {Value.unknown(reason)};
        if (!Double.isNaN(ageS)) {
            WaitPolicy.observing(() -> last[0] = ask(entry));
        }
        return new Reading(last[0], ageS, reason);
    }

    /** Returns the seconds since it was measured, or since the last report; NaN if there was none. */
    private double ageOf(ParameterTable.Entry entry) {
        LongSupplier measured = entry.measuredAt();
        long nanos = measured == null ? bot.state().atNanos() : measured.getAsLong();
        return nanos == 0 ? Double.NaN : (waiting.time().nanos() - nanos) / NANOS_PER_S;
    }
}
