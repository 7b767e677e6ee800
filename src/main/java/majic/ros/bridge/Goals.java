package majic.ros.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import majic.bot.LinkLost;
import org.jspecify.annotations.Nullable;

/** The goals of actions that have no result yet. Thread-safe. */
final class Goals {
    private final Map<String, ActionGoal.Events> open = new HashMap<>();

    /** Adds a goal; its id is unique at the server, which keeps one table for the goals of all clients (sheet 6). */
    synchronized String add(ActionGoal.Events events) {
        String id = "majic:goal:" + UUID.randomUUID();
        open.put(id, events);
        return id;
    }

    synchronized void remove(String id) {
        open.remove(id);
    }

    private synchronized ActionGoal.@Nullable Events find(String id, boolean last) {
        return last ? open.remove(id) : open.get(id);
    }

    void feedback(ObjectNode feedback) {
        ActionGoal.Events events = find(feedback.path("id").asText(), false);
        if (events != null) {
            events.feedback(feedback.path("values"));
        }
    }

    /** Passes a result on. Servers of early 2024 have status and result inside of the values (sheet 6). */
    void result(ObjectNode result) {
        ActionGoal.Events events = find(result.path("id").asText(), true);
        if (events == null) {
            return;
        }
        JsonNode values = result.path("values");
        if (result.has("status") || !values.has("status")) {
            events.result(result.path("status").asInt(), values);
        } else {
            events.result(values.path("status").asInt(), values.path("result"));
        }
    }

    void end(LinkLost cause) {
        List<ActionGoal.Events> all;
        synchronized (this) {
            all = new ArrayList<>(open.values());
            open.clear();
        }
        all.forEach(events -> events.failed(cause));
    }
}
