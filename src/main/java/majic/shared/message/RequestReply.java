package majic.shared.message;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Locale;
import majic.bot.MotionReport;
import majic.bot.Unit;
import majic.bot.Value;
import org.jspecify.annotations.Nullable;

/**
 * The answer to a request or to a stop. Immutable.
 *
 * @param outcome what became of it
 * @param message why it was not done, as a sentence; empty otherwise
 * @param report how far a motion went and how long it took; null for all else
 * @param value the value that was asked for, as {@link ValueJson} writes it; null for all else
 * @param text the answer of a command; empty for none
 */
public record RequestReply(
        Outcome outcome,
        String message,
        @Nullable MotionReport report,
        @Nullable JsonNode value,
        String text) {
    private static final String WHAT = "answer";
    private static final int MOST_BYTES = 256 * 1024;

    /** What became of a request. */
    public enum Outcome {
        /** It waits for its turn, or is being done; another answer follows. */
        ACCEPTED,
        /** It was done. */
        DONE,
        /** A stop ended it. */
        STOPPED,
        /** Nothing was done. */
        REFUSED,
        /** It could not be done, perhaps after a part of it. */
        FAILED,
        /** The connection of the desk with its robot was lost. */
        LOST
    }

    /**
     * An answer without further content.
     *
     * @param outcome what became of the request
     * @param message why, or empty
     * @return the answer
     */
    public static RequestReply of(Outcome outcome, String message) {
        return new RequestReply(outcome, message, null, null, "");
    }

    /**
     * The answer to a motion that has ended without an error.
     *
     * @param report how far it went
     * @return the answer
     */
    public static RequestReply done(MotionReport report) {
        return new RequestReply(Outcome.DONE, "", report, null, "");
    }

    /**
     * The answer to a question for a value.
     *
     * @param value the value
     * @return the answer
     */
    public static RequestReply done(Value value) {
        return new RequestReply(Outcome.DONE, "", null, ValueJson.of(value), "");
    }

    /**
     * The answer to everything else that was done.
     *
     * @param text the answer of a command; empty for none
     * @return the answer
     */
    public static RequestReply done(String text) {
        return new RequestReply(Outcome.DONE, "", null, null, text);
    }

    /**
     * Returns whether another answer follows.
     *
     * @return true only for {@link Outcome#ACCEPTED}
     */
    public boolean isFirst() {
        return outcome == Outcome.ACCEPTED;
    }

    /**
     * Writes the message.
     *
     * @return JSON in UTF-8
     */
    public byte[] toJson() {
        ObjectNode json = JsonObject.create().put("outcome", outcome.name().toLowerCase(Locale.ROOT));
        if (!message.isEmpty()) {
            json.put("message", message);
        }
        if (report != null) {
            json.put("seconds", Math.rint(report.seconds() * 1000) / 1000);
            if (report.amount() instanceof Value.Number amount) {
                json.set("amount", amount(amount));
            } else if (report.amount() != null) {
                json.put("amount", report.amount().toString());
            }
        }
        if (value != null) {
            json.set("value", value);
        }
        if (!text.isEmpty()) {
            json.put("text", text);
        }
        return JsonObject.bytes(json);
    }

    private static ObjectNode amount(Value.Number amount) {
        ObjectNode json = JsonObject.create()
                .put("number", amount.amount())
                .put("unit", amount.unit().symbol());
        return amount.about() ? json.put("about", true) : json;
    }

    /**
     * Reads a message.
     *
     * @param payload JSON in UTF-8
     * @return the answer
     * @throws UnusableMessageException if it is none
     */
    public static RequestReply parse(byte[] payload) {
        JsonObject json = JsonObject.parse(WHAT, payload, MOST_BYTES);
        MotionReport report = json.has("seconds") ? new MotionReport(readAmount(json), json.number("seconds")) : null;
        return new RequestReply(
                outcome(json), json.text("message", ""), report, json.node("value"), json.text("text", ""));
    }

    private static @Nullable Value readAmount(JsonObject json) {
        JsonNode node = json.node("amount");
        if (node == null || node.isTextual()) {
            return node == null ? null : Value.text(node.textValue());
        }
        JsonObject amount = json.object("amount");
        Unit unit = DescriptionJson.unit(amount.text("unit", ""));
        return new Value.Number(amount.number("number"), unit, amount.flag("about", false));
    }

    private static Outcome outcome(JsonObject json) {
        return switch (json.text("outcome")) {
            case "accepted" -> Outcome.ACCEPTED;
            case "done" -> Outcome.DONE;
            case "stopped" -> Outcome.STOPPED;
            case "refused" -> Outcome.REFUSED;
            case "lost" -> Outcome.LOST;
            default -> Outcome.FAILED;
        };
    }
}
