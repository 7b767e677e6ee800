package majic.aibo.urbi;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/** The commands of one connection that still wait for an answer, oldest first. Thread-safe. */
public final class PendingRequests {
    /**
     * A syntax error names a place; other errors under the same tag answer no command (URBI sheet 11). Of the two lines
     * about a command that found the server's queue full, the first one answers it (URBI sheet 2).
     */
    private static final Pattern ANSWERS_A_COMMAND = Pattern.compile("\\d+\\.\\d.*|Receive buffer full.*");

    private final Map<String, UrbiRequest> asks = new LinkedHashMap<>();

    public synchronized void add(UrbiRequest ask) {
        asks.put(ask.tag(), ask);
    }

    synchronized void remove(UrbiRequest ask) {
        asks.remove(ask.tag());
    }

    /** Passes a message to the request it answers; returns that request, null if none. */
    public @Nullable UrbiRequest answer(UrbiMessage message, UrbiVersion version) {
        UrbiRequest ask = addressee(message, version);
        if (ask == null) {
            return null;
        }
        if (message.body() instanceof UrbiMessage.Info complaint && message.isError()) {
            ask.fail(complaint.text(), message.timeMs());
        } else {
            ask.accept(message);
        }
        if (ask.isDone()) {
            remove(ask);
        }
        return ask;
    }

    private synchronized @Nullable UrbiRequest addressee(UrbiMessage message, UrbiVersion version) {
        UrbiRequest tagged = asks.get(message.tag());
        if (tagged != null) {
            return tagged;
        }
        if (message.isError()) {
            return answersACommand(message.body()) ? oldest(asks.values().stream()) : null;
        }
        return message.tag().equals(UrbiMessage.NO_TAG) ? untagged(message.body(), version) : null;
    }

    /** A syntax error carries the tag {@code error} whatever the command's was; before 1.0 it began with asterisks. */
    private static boolean answersACommand(UrbiMessage.Body body) {
        String text = body instanceof UrbiMessage.Failure failure
                ? failure.text()
                : body instanceof UrbiMessage.Info info ? info.text() : "";
        return ANSWERS_A_COMMAND.matcher(text).matches();
    }

    /** Where servers leave tags out: 1.5 does so on all but flags and channels (URBI sheet 1). */
    private @Nullable UrbiRequest untagged(UrbiMessage.Body body, UrbiVersion version) {
        if (body instanceof UrbiMessage.Info info && info.text().startsWith("pong")) {
            return oldest(asks.values().stream().filter(UrbiRequest::expectsPong));
        }
        boolean fails = body instanceof UrbiMessage.Failure && version == UrbiVersion.V1_5;
        return fails ? oldest(asks.values().stream()) : null;
    }

    private static @Nullable UrbiRequest oldest(Stream<UrbiRequest> candidates) {
        return candidates.findFirst().orElse(null);
    }
}
