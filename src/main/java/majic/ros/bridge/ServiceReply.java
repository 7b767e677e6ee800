package majic.ros.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Optional;
import majic.bot.LinkLost;

/** The answer of a service that was called without waiting. Thread-safe. */
public final class ServiceReply implements AutoCloseable {
    private final ServiceCall call;
    private final Runnable forget;

    ServiceReply(ServiceCall call, Runnable forget) {
        this.call = call;
        this.forget = forget;
    }

    /**
     * Returns whether the call is over.
     *
     * @return true once the service has answered or failed, or the connection has ended
     */
    public boolean isDone() {
        return call.isDone();
    }

    /**
     * Returns the answer.
     *
     * @return the values; empty if the call is not over
     * @throws ServiceFailed if the server reported a failure
     * @throws LinkLost if the connection ended first
     */
    public Optional<JsonNode> values() {
        return Optional.ofNullable(call.result());
    }

    /** Ignores the answer if it arrives later. */
    @Override
    public void close() {
        forget.run();
    }
}
