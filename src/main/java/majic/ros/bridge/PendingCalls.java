package majic.ros.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import majic.bot.LinkLost;
import org.jspecify.annotations.Nullable;

/** The calls of services that have no answer yet. Thread-safe. */
final class PendingCalls {
    private final AtomicLong last = new AtomicLong();
    private final Map<String, ServiceCall> open = new HashMap<>();
    private @Nullable LinkLost ended;

    /**
     * Adds a call.
     *
     * @return its id on this connection
     * @throws LinkLost if the connection has ended
     */
    synchronized String add(ServiceCall call) {
        if (ended != null) {
            throw new LinkLost(String.valueOf(ended.getMessage()), ended);
        }
        String id = "majic:call:" + last.incrementAndGet();
        open.put(id, call);
        return id;
    }

    synchronized void remove(String id) {
        open.remove(id);
    }

    /** Completes the call that an answer belongs to; a late answer is ignored. */
    void answered(ObjectNode response) {
        ServiceCall call;
        synchronized (this) {
            call = open.remove(response.path("id").asText());
        }
        if (call == null) {
            return;
        }
        JsonNode values = response.path("values");
        // A server that reports no result has none to report: only false is a failure.
        if (response.path("result").asBoolean(true)) {
            call.succeeded(values);
        } else {
            call.failed(new ServiceFailed(
                    call.service() + ": " + (values.isTextual() ? values.textValue() : values.toString()), true));
        }
    }

    /** Fails all calls, and those that are added later. */
    void end(LinkLost cause) {
        List<ServiceCall> all;
        synchronized (this) {
            ended = cause;
            all = new ArrayList<>(open.values());
            open.clear();
        }
        all.forEach(call -> call.failed(cause));
    }
}
