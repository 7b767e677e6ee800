package majic.shared.vda5050;

import com.fasterxml.jackson.databind.node.ArrayNode;
import java.util.LinkedHashMap;
import java.util.Map;

/** The newest instant actions of one vehicle, and what became of them. Thread-safe. */
final class ActionStates {
    private static final int MOST = 50;

    private final Map<String, Entry> entries = new LinkedHashMap<>();

    /** How far an action is, in the words of the specification. */
    enum Status {
        /** It is being carried out. */
        RUNNING,
        /** It was carried out. */
        FINISHED,
        /** It could not be carried out. */
        FAILED
    }

    private record Entry(String type, Status status, String result) {}

    /** Notes a new action; false if its id is known, and so it must not be carried out again. */
    synchronized boolean begin(String id, String type) {
        if (entries.containsKey(id)) {
            return false;
        }
        if (entries.size() >= MOST) {
            entries.remove(entries.keySet().iterator().next());
        }
        entries.put(id, new Entry(type, Status.RUNNING, ""));
        return true;
    }

    synchronized void end(String id, Status status, String result) {
        entries.computeIfPresent(id, (key, entry) -> new Entry(entry.type, status, result));
    }

    synchronized void write(ArrayNode to) {
        entries.forEach((id, entry) -> to.addObject()
                .put("actionId", id)
                .put("actionType", entry.type)
                .put("actionStatus", entry.status.name())
                .put("resultDescription", entry.result));
    }
}
