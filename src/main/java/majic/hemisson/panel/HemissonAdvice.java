package majic.hemisson.panel;

import majic.text.ErrorWords;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * The most urgent advice for the user: how to stop a robot that cannot be reached, why a click was refused, or what is
 * wrong with its switches. For the event thread.
 */
final class HemissonAdvice {
    private static final Texts TEXTS = Texts.of(HemissonAdvice.class);
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
        refusal = ErrorWords.of(why);
        refusedNanos = nowNanos;
    }

    Words on(HemissonScene view, long nowNanos) {
        String why = nowNanos - refusedNanos < REFUSAL_NANOS ? refusal : null;
        if (view.line().outOfControl()) {
            return new Words(TEXTS.get("lift"), true);
        }
        if (why != null) {
            return new Words(why, false);
        }
        if (view.isConnected() && !view.isRemoteControlled()) {
            return new Words(TEXTS.get("otherMode", view.mode()), false);
        }
        return NONE;
    }
}
