package majic.hemisson.panel;

import org.jspecify.annotations.Nullable;

/**
 * The most urgent advice for the user: how to stop a robot that cannot be reached, why a click was refused, or what is
 * wrong with its switches. For the event thread.
 */
final class HemissonAdvice {
    static final Words LIFT =
            new Words("It cannot be reached and may be moving: lift it, or press 5 on a TV remote control.", true);

    private static final Words NONE = new Words("", false);
    private static final long REFUSAL_NANOS = 8_000_000_000L;

    private @Nullable String refusal;
    private long refusedNanos;

    /**
     * A piece of advice.
     *
     * @param text whole sentences; empty for none
     * @param urgent whether the user must act at once
     */
    record Words(String text, boolean urgent) {}

    /** Shows for some seconds why a click was refused. */
    void refused(String why, long nowNanos) {
        refusal = why;
        refusedNanos = nowNanos;
    }

    Words on(HemissonScene view, long nowNanos) {
        String why = nowNanos - refusedNanos < REFUSAL_NANOS ? refusal : null;
        if (view.line().outOfControl()) {
            return LIFT;
        }
        if (why != null) {
            return new Words(why, false);
        }
        if (view.isConnected() && !view.isRemoteControlled()) {
            return new Words(
                    "It runs as its switches say (" + view.mode()
                            + ") and may move by itself: set all four to the side marked 1, then switch it off and on.",
                    false);
        }
        return NONE;
    }
}
