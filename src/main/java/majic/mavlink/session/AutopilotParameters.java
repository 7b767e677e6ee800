package majic.mavlink.session;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import majic.bot.BotException;
import majic.driver.RobotWait;
import majic.mavlink.message.AutopilotVersion;
import majic.mavlink.message.MavlinkRequests;
import majic.mavlink.message.ParameterValue;
import org.jspecify.annotations.Nullable;

/**
 * The parameters of an autopilot. There are more than a thousand, so each is read when it is asked for. Thread-safe.
 */
public final class AutopilotParameters {
    private static final double ANSWER_S = 1.5;
    private static final int TIMES = 3;
    private static final int REAL = 9;

    private final VehicleSession session;
    private final RobotWait waiting;
    private final AtomicLong arrivals = new AtomicLong();
    private final Map<String, Arrived> values = new ConcurrentHashMap<>();

    private final ParameterList list;

    /** A value, and how many have come before it: one that was there before a request is no answer to it. */
    private record Arrived(ParameterValue value, long number) {}

    AutopilotParameters(VehicleSession session, RobotWait waiting) {
        this.session = session;
        this.waiting = waiting;
        this.list = new ParameterList(session, waiting.time());
    }

    /** Takes a value, which may come unasked; on the reader thread. */
    void take(ParameterValue value) {
        list.take(value);
        values.put(value.name(), new Arrived(value, arrivals.getAndIncrement()));
    }

    /** Returns the names that have come so far; the first call asks for all, in the background. */
    public List<String> names() {
        return list.names();
    }

    /** Asks again for values that were lost while all were being sent; called often. */
    void check() {
        list.check();
    }

    /**
     * Returns the value that came last.
     *
     * @param name in capitals
     * @return empty if none has come
     */
    public Optional<Double> known(String name) {
        return Optional.ofNullable(values.get(name)).map(arrived -> number(arrived.value()));
    }

    /** Asks for values and waits for none of them. */
    void request(String... names) {
        for (String name : names) {
            session.send(MavlinkRequests.readParameter(session.system(), name));
        }
    }

    /**
     * Reads a value; asks three times.
     *
     * @param name in capitals
     * @return the value; empty if it is not answered, as for a name that there is not
     */
    public Optional<Double> read(String name) {
        return Optional.ofNullable(ask(name)).map(this::number);
    }

    private @Nullable ParameterValue ask(String name) {
        long from = arrivals.get();
        for (int times = 0; times < TIMES; times++) {
            session.send(MavlinkRequests.readParameter(session.system(), name));
            if (waiting.await(() -> newest(name, from) != null || session.hasEnded(), ANSWER_S)) {
                break;
            }
        }
        return newest(name, from);
    }

    private @Nullable ParameterValue newest(String name, long from) {
        Arrived arrived = values.get(name);
        return arrived != null && arrived.number() >= from ? arrived.value() : null;
    }

    /**
     * Sets a value, and waits until the autopilot reports it. Another value that comes first may have been sent before
     * the request, whatever its index (an answer to a read has the index of an answer to a set), so it decides nothing:
     * what the autopilot keeps is read anew.
     *
     * @param name in capitals
     * @throws BotException if there is no such parameter, or it has another value afterwards
     */
    public void set(String name, double value) {
        ParameterValue before = ask(name);
        if (before == null) {
            throw new BotException(name + ": the autopilot has no parameter of this name, or did not answer");
        }
        if (before.type() != REAL && value != Math.rint(value)) {
            throw new BotException(name + ": not a whole number");
        }
        long from = arrivals.get();
        for (int times = 0; times < TIMES; times++) {
            session.send(MavlinkRequests.setParameter(session.system(), name, bits(before, value), before.type()));
            if (waiting.await(() -> is(newest(name, from), value) || session.hasEnded(), ANSWER_S)
                    || mayAnswer(newest(name, from))) {
                break;
            }
        }
        ParameterValue after = newest(name, from);
        if (after != null && !is(after, value) && !session.hasEnded()) {
            after = ask(name);
        }
        if (after == null) {
            throw new BotException(name + ": the autopilot did not confirm the new value");
        }
        if (!is(after, value)) {
            throw new BotException(String.format(
                    Locale.ROOT, "%s: the autopilot keeps %s in place of %s", name, number(after), value));
        }
    }

    private static boolean mayAnswer(@Nullable ParameterValue reported) {
        return reported != null && reported.index() == ParameterValue.NO_INDEX;
    }

    private boolean is(@Nullable ParameterValue reported, double value) {
        return reported != null && number(reported) == (reported.type() == REAL ? (float) value : value);
    }

    /** What it means that a read is not answered, as half a sentence. */
    public static String unanswered(String name) {
        return "the autopilot has no parameter " + name + ", or did not answer within "
                + String.format(Locale.ROOT, "%.1f", TIMES * ANSWER_S) + " s";
    }

    private double number(ParameterValue value) {
        return isSentAsBits(value) ? value.bits() : value.value();
    }

    private int bits(ParameterValue before, double value) {
        return isSentAsBits(before) ? (int) value : Float.floatToIntBits((float) value);
    }

    /** Whole numbers are bits, as with PX4, unless the autopilot is ArduPilot or says otherwise (MAVLink sheet 8). */
    private boolean isSentAsBits(ParameterValue value) {
        return value.type() != REAL
                && !session.modes().isArduPilot()
                && !session.version().map(AutopilotVersion::castsParameters).orElse(false);
    }
}
