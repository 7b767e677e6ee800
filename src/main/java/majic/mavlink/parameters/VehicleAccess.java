package majic.mavlink.parameters;

import java.util.List;
import java.util.function.Function;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.MotionFailed;
import majic.bot.Value;
import majic.mavlink.motion.VehicleMotion;
import majic.mavlink.ranging.VehicleRanges;
import majic.mavlink.session.VehicleSession;
import org.jspecify.annotations.Nullable;

/** What parameters and commands use of the driver, whose connection may be another one at each use. Thread-safe. */
public final class VehicleAccess {
    /** What comes once a second is old after this time, seconds. */
    static final double OLD_S = 3;

    static final Value NOT_CONNECTED = Value.unknown("not connected");
    static final Value NOT_REPORTED = Value.unknown("the autopilot does not report it");

    private final Supplier<@Nullable Parts> parts;

    /**
     * The parts of one connection.
     *
     * @param session its messages
     * @param motion its motions
     * @param ranges its distances
     */
    public record Parts(VehicleSession session, VehicleMotion motion, VehicleRanges ranges) {}

    /** Reads the parts of the present connection; null while there is none. */
    public VehicleAccess(Supplier<@Nullable Parts> parts) {
        this.parts = parts;
    }

    /** A reader of the newest message of a class. */
    <T> Supplier<Value> newest(Class<T> type, Function<T, Value> reader) {
        return read(
                open -> open.session().reports().newest(type, OLD_S).map(reader).orElse(NOT_REPORTED));
    }

    Supplier<Value> read(Function<Parts, Value> reader) {
        return () -> {
            Parts open = parts.get();
            return open == null ? NOT_CONNECTED : reader.apply(open);
        };
    }

    /** The names of the autopilot's parameters that have come so far; none without a connection. */
    List<String> names() {
        Parts open = parts.get();
        return open == null || open.session().hasEnded()
                ? List.of()
                : open.session().parameters().names();
    }

    /**
     * The parts of the present connection, for what moves the vehicle.
     *
     * @throws MotionFailed if another vehicle has its number
     */
    Parts alone() {
        Parts open = open();
        open.session().failIfDoubled();
        return open;
    }

    Parts open() {
        Parts open = parts.get();
        if (open == null) {
            throw new BotException("the vehicle is not connected");
        }
        return open;
    }
}
