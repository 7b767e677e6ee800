package majic.aibo.urbi;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/** The commands of one connection that something is still expected to come back for, oldest first. Thread-safe. */
public final class Unanswered {
    /**
     * A syntax error names a place; other troubles under the same tag answer no command (URBI sheet 11). Of the two lines
     * about a command that there was no room for the first one answers it (URBI sheet 2).
     */
    private static final Pattern ANSWERS_A_COMMAND = Pattern.compile("\\d+\\.\\d.*|Receive buffer full.*");

    private final Map<String, Ask> asks = new LinkedHashMap<>();

    public synchronized void add(Ask ask) {
        asks.put(ask.tag(), ask);
    }

    synchronized void remove(Ask ask) {
        asks.remove(ask.tag());
    }

    /** Hands a message to the command it answers; tells which that was, null if none. */
    public @Nullable Ask answer(UrbiMessage message, Dialect dialect) {
        Ask ask = addressee(message, dialect);
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

    private synchronized @Nullable Ask addressee(UrbiMessage message, Dialect dialect) {
        Ask tagged = asks.get(message.tag());
        if (tagged != null) {
            return tagged;
        }
        if (message.isError()) {
            return answersACommand(message.body()) ? oldest(asks.values().stream()) : null;
        }
        return message.tag().equals(UrbiMessage.NO_TAG) ? untagged(message.body(), dialect) : null;
    }

    /** A syntax error carries the tag {@code error} whatever the command's was; before 1.0 it began with asterisks. */
    private static boolean answersACommand(UrbiMessage.Body body) {
        String text = body instanceof UrbiMessage.Failure failure
                ? failure.text()
                : body instanceof UrbiMessage.Info info ? info.text() : "";
        return ANSWERS_A_COMMAND.matcher(text).matches();
    }

    /** Where servers leave tags out: 1.5 does so on all but flags and channels (URBI sheet 1). */
    private @Nullable Ask untagged(UrbiMessage.Body body, Dialect dialect) {
        if (body instanceof UrbiMessage.Info info && info.text().startsWith("pong")) {
            return oldest(asks.values().stream().filter(Ask::expectsPong));
        }
        boolean fails = body instanceof UrbiMessage.Failure && dialect == Dialect.V1_5;
        return fails ? oldest(asks.values().stream()) : null;
    }

    private static @Nullable Ask oldest(Stream<Ask> candidates) {
        return candidates.findFirst().orElse(null);
    }
}
