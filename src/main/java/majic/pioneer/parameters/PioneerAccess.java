package majic.pioneer.parameters;

import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.RangeScan;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.AssumedSetting;
import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.ConfigField;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.ReportKind;
import majic.pioneer.session.PioneerSession;
import majic.pioneer.session.SessionLaser;
import majic.pioneer.session.Subscriptions;
import majic.pioneer.state.PioneerState;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * Connects parameters with the robot: reads its last reports, sends commands and waits for their effect. For all
 * sessions. Thread-safe.
 */
public final class PioneerAccess {
    static final Value NOTHING_YET = Value.unknown("no reading yet");
    static final Value NOTHING_RECENT = Value.unknown("no reading of late");
    static final Value UNSCALED = Value.unknown("the scale of this model is not known");
    static final Value NEVER = Value.text("never");
    static final Value NOT_REPORTED = Value.unknown("this robot does not tell");

    /** Time enough for a command and the SIP that shows its effect, seconds. */
    private static final double CONFIRM_S = 1;

    /** Time enough for a request and its report, seconds. */
    private static final double REPORT_S = 2 * Subscriptions.PERIOD_S;

    private final Supplier<@Nullable PioneerSession> session;

    public PioneerAccess(Supplier<@Nullable PioneerSession> session) {
        this.session = session;
    }

    /**
     * The current session.
     *
     * @throws BotException if there has been none yet
     */
    PioneerSession open() {
        PioneerSession open = session.get();
        if (open == null) {
            throw new BotException("not connected");
        }
        return open;
    }

    /** Reads from the robot's last state. */
    Supplier<Value> state(Function<PioneerState, Value> reader) {
        return session(open -> open.hasReported() ? reader.apply(open.state()) : NOTHING_YET);
    }

    /**
     * Reads from the sonars. In the first second after connecting, when not all of them have fired, the first readings
     * are awaited, if the thread may wait.
     *
     * @param come whether the readings have come
     */
    Supplier<Value> sonar(Predicate<PioneerState> come, Function<PioneerState, Value> reader) {
        return session(open -> {
            if (!open.hasReported()) {
                return NOTHING_YET;
            }
            open.awaitFirstReadings(come);
            return scaled(reader).get();
        });
    }

    /** Reads from the robot's last state what can be computed only with the scale of its counts. */
    Supplier<Value> scaled(Function<PioneerState, Value> reader) {
        Supplier<Value> scaled = state(reader);
        return session(open -> open.equipment().model().known() ? scaled.get() : UNSCALED);
    }

    /**
     * Reads from a report that comes beside the SIPs. Without a recent report one is requested and, if the thread may
     * wait, awaited.
     */
    Supplier<Value> report(ReportKind kind, Function<PioneerState, Optional<Value>> reader) {
        return session(open -> {
            if (!open.hasReported()) {
                return NOTHING_YET;
            }
            if (hasFresh(open, kind)) {
                return reader.apply(open.state()).orElseGet(() -> missing(open));
            }
            return open.subscriptions().isMissing(kind) || WaitPolicy.isAllowed() ? missing(open) : NOTHING_RECENT;
        });
    }

    /** Whether the robot has sent a scan of a laser. */
    boolean hasLaser() {
        PioneerSession open = session.get();
        return open != null && open.laser().isThere();
    }

    /** Reads from a scan of the laser. Without a recent one it is requested and, if the thread may wait, awaited. */
    Supplier<Value> laser(Function<RangeScan, Value> reader) {
        return session(open -> {
            SessionLaser laser = open.laser();
            laser.read();
            open.await(state -> laser.fresh().isPresent(), REPORT_S);
            return laser.fresh().map(reader).orElse(NOTHING_RECENT);
        });
    }

    private static boolean hasFresh(PioneerSession open, ReportKind kind) {
        Subscriptions subscriptions = open.subscriptions();
        subscriptions.read(kind);
        return !subscriptions.isMissing(kind) && open.await(state -> subscriptions.isFresh(kind), REPORT_S);
    }

    /** Reads from the session. */
    Supplier<Value> session(Function<PioneerSession, Value> reader) {
        return () -> {
            PioneerSession open = session.get();
            return open == null ? Value.unknown("not connected") : reader.apply(open);
        };
    }

    /** A value that does not come over the connection of a session. */
    static Value missing(PioneerSession open) {
        return Value.unknown(open.missing());
    }

    /** Reads a field of the robot's CONFIG packet; empty if the packet says that there is no such value. */
    Supplier<Value> config(ConfigField field, Function<Config, Optional<Value>> reader) {
        return session(open -> {
            Config config = open.config();
            return config == null || !config.isKnown(field)
                    ? missing(open)
                    : reader.apply(config).orElse(NOT_REPORTED);
        });
    }

    /** Reads a text of the CONFIG packet. */
    Supplier<Value> config(ConfigField text) {
        return config(
                text,
                config -> Optional.of(config.text(text))
                        .filter(found -> !found.isEmpty())
                        .map(Value::text));
    }

    /**
     * Reads a number of the CONFIG packet, of which zero means that there is no such value.
     *
     * @param divisor the number for one unit
     */
    Supplier<Value> config(ConfigField number, Unit unit, int divisor) {
        return config(
                number,
                config -> Optional.of((double) config.number(number) / divisor)
                        .filter(value -> value != 0)
                        .map(value -> Value.of(value, unit)));
    }

    /**
     * Reads a number of the CONFIG packet, of which zero means that something never happens.
     *
     * @param divisor the number for one unit
     */
    Supplier<Value> configOrNever(ConfigField number, Unit unit, int divisor) {
        return config(
                number,
                config -> Optional.of(
                        config.number(number) == 0 ? NEVER : Value.of((double) config.number(number) / divisor, unit)));
    }

    /**
     * Sends a command and, if the thread may wait, waits for the SIP that shows its effect.
     *
     * @param complaint the missing effect, as half a sentence: "the motors did not switch on"
     * @throws BotException if no SIP shows it in time
     * @throws LinkLost if the connection is gone
     */
    void sendAndConfirm(Packet packet, Predicate<PioneerState> done, String complaint) {
        PioneerSession open = open();
        open.send(packet);
        if (WaitPolicy.isAllowed() && !open.await(done, CONFIRM_S)) {
            throw new BotException(complaint + " within " + Value.plain(CONFIRM_S) + " s");
        }
    }

    /** The complaint about a switch without effect, behind the name of what was to be switched. */
    static String didNotSwitch(boolean on) {
        return "did not switch " + (on ? "on" : "off");
    }

    /** Reads a setting that the robot does not report. */
    Supplier<Value> assumed(AssumedSetting setting) {
        return session(setting::in);
    }

    /** Reads a setting that the robot reports only as it was at the start of the session. */
    Supplier<Value> assumed(AssumedSetting setting, Supplier<Value> initial) {
        return session(open -> setting.in(open, initial));
    }

    /** Sends a setting that the robot does not report. */
    void send(AssumedSetting setting, Packet packet, Value value) {
        PioneerSession open = open();
        open.send(packet);
        setting.sent(open, value);
    }

    /** Sends a command without a visible effect. */
    void send(Packet packet) {
        open().send(packet);
    }
}
