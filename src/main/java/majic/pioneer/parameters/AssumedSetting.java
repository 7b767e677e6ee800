package majic.pioneer.parameters;

import java.util.function.Supplier;
import majic.bot.Value;
import majic.pioneer.session.PioneerSession;
import org.jspecify.annotations.Nullable;

/**
 * A setting that the robot takes but never tells: what it was last told, for the session in which it was told. Thread-safe.
 */
final class AssumedSetting {
    private static final Value NEVER = Value.unknown("the robot does not tell, and nobody has set it");

    private final PioneerAccess access;
    private volatile @Nullable Setting last;

    private record Setting(PioneerSession session, Value value) {}

    AssumedSetting(PioneerAccess access) {
        this.access = access;
    }

    /** Sends it and keeps it. */
    void tell(byte[] packet, Value value) {
        PioneerSession open = access.open();
        open.send(packet);
        last = new Setting(open, value);
    }

    /** Whether it was told this last, in the session there is. */
    boolean was(Value value) {
        Setting known = last;
        return known != null
                && known.session() == access.open()
                && known.value().equals(value);
    }

    /** Reads what it was told; unknown before, as a new session forgets it. */
    Supplier<Value> reader(Supplier<Value> before) {
        return access.session(open -> {
            Setting known = last;
            return known != null && known.session() == open ? known.value() : before.get();
        });
    }

    /** Reads what it was told, where the robot never says what it has from the start. */
    Supplier<Value> reader() {
        return reader(() -> NEVER);
    }
}
