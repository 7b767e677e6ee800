package majic.hemisson.line;

import org.jspecify.annotations.Nullable;

/**
 * The exchange that waits for its answer, and the one that a stop has overtaken and that is answered before the stop.
 * Guarded by its owner.
 */
final class OpenExchanges {
    private static final String OVERTAKEN = "no answer before the stop";

    private @Nullable Exchange newest;
    private @Nullable Exchange overtaken;

    /** The exchange that was sent last; null if none waits for an answer. */
    @Nullable
    Exchange newest() {
        return newest;
    }

    /** The exchange that is answered next; null if none waits for an answer. */
    @Nullable
    Exchange oldest() {
        return overtaken == null ? newest : overtaken;
    }

    /** Adds an exchange that is sent now; it overtakes the one that waits. */
    void sent(Exchange next) {
        overtaken = newest;
        newest = next;
    }

    /** The exchange that a reply answers, as the robot answers in the order of the questions; null if there is none. */
    @Nullable
    Exchange answeredBy(Reply reply) {
        Exchange before = overtaken;
        if (before != null && before.question().isAnsweredBy(reply)) {
            return before;
        }
        Exchange open = newest;
        return open != null && open.question().isAnsweredBy(reply) ? open : null;
    }

    /** Removes an exchange that is done; the one that it overtook ends with it. */
    void remove(Exchange done) {
        remove(done, OVERTAKEN);
    }

    /**
     * Removes an exchange that is done.
     *
     * @param why the failure of the one that it overtook
     */
    void remove(Exchange done, String why) {
        Exchange before = overtaken;
        overtaken = null;
        if (done == newest) {
            newest = null;
            if (before != null) {
                before.failed(why);
            }
        }
    }

    /** Ends all. */
    void discard(String why) {
        Exchange open = newest;
        if (open != null) {
            open.failed(why);
            remove(open, why);
        }
    }
}
