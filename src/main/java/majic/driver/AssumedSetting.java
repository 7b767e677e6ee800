package majic.driver;

import java.util.function.Supplier;
import majic.bot.Value;
import org.jspecify.annotations.Nullable;

/**
 * A setting that a robot accepts but never reports: the value that was last sent, which holds for the session in which
 * it was sent. Thread-safe.
 */
public final class AssumedSetting {
    private static final Value NEVER_SENT = Value.unknown("the robot does not report it, and it was not set");

    private volatile @Nullable Sent last;

    private record Sent(Object session, Value value) {}

    /**
     * Records a value that was sent.
     *
     * @param session in which it was sent; compared by identity
     * @param value as sent
     */
    public void sent(Object session, Value value) {
        last = new Sent(session, value);
    }

    /**
     * The value sent in a session.
     *
     * @param session the one that is open
     * @return the value; unknown if none was sent in this session
     */
    public Value in(Object session) {
        return in(session, () -> NEVER_SENT);
    }

    /**
     * The value sent in a session, or the one that the robot had from the start.
     *
     * @param session the one that is open
     * @param initial gives the value from the start of a session
     * @return the value sent in this session; otherwise the initial one
     */
    public Value in(Object session, Supplier<Value> initial) {
        Sent known = last;
        return known != null && known.session() == session ? known.value() : initial.get();
    }
}
