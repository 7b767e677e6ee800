package majic.shared.message;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.time.Instant;
import java.time.format.DateTimeParseException;
import java.time.temporal.ChronoUnit;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import majic.text.VisibleText;
import org.jspecify.annotations.Nullable;

/**
 * STOP of the whole team, or its release. Immutable.
 *
 * @param latched whether motion is refused from now on
 * @param id of the STOP; empty for a release
 * @param releases the ids of the STOPs that end; empty for a STOP
 * @param desk the desk at which it was pressed
 * @param person the user of that desk; may be empty
 * @param time when, by the clock of that desk, for display only; null if it is not known
 */
public record LatchMessage(
        boolean latched,
        String id,
        Set<String> releases,
        String desk,
        String person,
        @Nullable Instant time) {
    private static final String WHAT = "stop of the team";
    private static final int MOST_BYTES = 64 * 1024;

    /** Keeps a copy of the ids. */
    public LatchMessage {
        releases = Set.copyOf(releases);
    }

    /**
     * A STOP.
     *
     * @param id random
     * @param by name of the user and desk at which STOP was pressed
     * @param time when it was pressed; null if that is not known
     * @return the message
     */
    public static LatchMessage stop(String id, Sender by, @Nullable Instant time) {
        return new LatchMessage(true, id, Set.of(), by.desk(), by.person(), time);
    }

    /**
     * A release.
     *
     * @param ids of the STOPs that end
     * @param by name of the user and desk that released
     * @return the message
     */
    public static LatchMessage release(Collection<String> ids, Sender by) {
        return new LatchMessage(false, "", Set.copyOf(ids), by.desk(), by.person(), null);
    }

    /**
     * Returns the name of the user and desk that sent it.
     *
     * @return {@code Anna at desk1}
     */
    public String by() {
        return VisibleText.of(person.isEmpty() ? desk : person + " at " + desk);
    }

    /**
     * Writes the message.
     *
     * @return JSON in UTF-8
     */
    public byte[] toJson() {
        ObjectNode json = JsonObject.create().put("latched", latched);
        if (latched) {
            json.put("id", id);
        } else {
            ArrayNode ids = json.putArray("releases");
            releases.forEach(ids::add);
        }
        if (time != null) {
            json.put("time", time.truncatedTo(ChronoUnit.SECONDS).toString());
        }
        return JsonObject.bytes(json.put("desk", desk).put("person", person));
    }

    /**
     * Reads a message.
     *
     * @param payload JSON in UTF-8
     * @return the STOP or release
     * @throws UnusableMessageException if it is none
     */
    public static LatchMessage parse(byte[] payload) {
        JsonObject json = JsonObject.parse(WHAT, payload, MOST_BYTES);
        boolean latched = json.flag("latched");
        return new LatchMessage(
                latched,
                latched ? json.text("id") : "",
                latched ? Set.of() : Set.copyOf(List.copyOf(json.texts("releases"))),
                json.text("desk", "another desk"),
                json.text("person", ""),
                time(json.text("time", "")));
    }

    /** A time that cannot be read is left out: nothing depends on it. */
    private static @Nullable Instant time(String text) {
        try {
            return Instant.parse(text);
        } catch (DateTimeParseException e) {
            return null;
        }
    }
}
