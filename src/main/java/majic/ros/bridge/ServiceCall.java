package majic.ros.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import majic.bot.BotException;
import org.jspecify.annotations.Nullable;

/** One call of a service, from its request to its answer. Thread-safe. */
final class ServiceCall {
    private final String service;
    private final Runnable changed;
    private volatile @Nullable JsonNode values;
    private volatile @Nullable BotException failure;

    /**
     * A call without an answer.
     *
     * @param changed wakes the thread that waits for the answer
     */
    ServiceCall(String service, Runnable changed) {
        this.service = service;
        this.changed = changed;
    }

    String service() {
        return service;
    }

    void succeeded(JsonNode answer) {
        values = answer;
        changed.run();
    }

    void failed(BotException cause) {
        failure = cause;
        changed.run();
    }

    boolean isDone() {
        return values != null || failure != null;
    }

    /** Returns the answer of a call that is done, or throws its failure; null if it is not done. */
    @Nullable
    JsonNode result() {
        BotException cause = failure;
        if (cause != null) {
            throw cause;
        }
        return values;
    }
}
