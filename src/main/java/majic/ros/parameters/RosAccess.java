package majic.ros.parameters;

import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.Value;
import majic.ros.readings.RequestedReading;
import majic.ros.readings.RosReadings;
import org.jspecify.annotations.Nullable;

/** Connects parameters and commands with the readings of the present connection. For all connections. Thread-safe. */
public final class RosAccess {
    private static final Value NOT_CONNECTED = Value.unknown("not connected");

    private final Supplier<@Nullable RosReadings> present;

    /**
     * Creates the access.
     *
     * @param present gives the readings of the newest connection; null before the first one
     */
    public RosAccess(Supplier<@Nullable RosReadings> present) {
        this.present = present;
    }

    /**
     * Returns the readings of the present connection.
     *
     * @throws BotException before the first connection
     */
    RosReadings open() {
        return find().orElseThrow(() -> new BotException("not connected"));
    }

    Optional<RosReadings> find() {
        return Optional.ofNullable(present.get());
    }

    /** Reads from the readings of the present connection. */
    Supplier<Value> read(Function<RosReadings, Value> reader) {
        return () -> find().map(reader).orElse(NOT_CONNECTED);
    }

    /** Reads what is subscribed to only while something reads it. */
    <T> Supplier<Value> requested(
            Function<RosReadings, Optional<RequestedReading<T>>> which, Function<T, Value> reader) {
        return read(readings -> which.apply(readings)
                .map(reading -> reading.read().map(reader).orElseGet(reading::unknown))
                .orElse(Value.unknown("this robot does not report it")));
    }
}
