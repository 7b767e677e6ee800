package majic.hemisson.line;

import org.jspecify.annotations.Nullable;

/**
 * The result of a line from the robot, or of a timeout. Immutable.
 *
 * @param kind what happened
 * @param exchange the exchange that it happened to; null if to none
 */
record Outcome(Kind kind, @Nullable Exchange exchange) {
    /** No exchange was concerned. */
    static final Outcome NONE = new Outcome(Kind.NONE, null);

    /** The robot was switched on or reset. */
    static final Outcome RESET = new Outcome(Kind.RESET, null);

    private enum Kind {
        NONE,
        ANSWERED,
        MISSED,
        MISSED_IN_MOTION,
        RESET
    }

    static Outcome answered(Exchange exchange) {
        return new Outcome(Kind.ANSWERED, exchange);
    }

    static Outcome missed(Exchange exchange, boolean inMotion) {
        return new Outcome(inMotion ? Kind.MISSED_IN_MOTION : Kind.MISSED, exchange);
    }

    /** Calls the listener method for it. */
    void deliver(ConversationListener listener) {
        if (kind == Kind.RESET) {
            listener.wasReset();
        } else if (exchange != null && kind == Kind.ANSWERED) {
            listener.answered(exchange);
        } else if (exchange != null) {
            listener.missed(exchange, kind == Kind.MISSED_IN_MOTION);
        }
    }
}
