package majicsim.hemisson.uart;

import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.LinkedHashMap;
import java.util.Map;
import majicsim.net.Line;

/** Characters to be sent, each with the time at which its transmission ends. */
final class CharacterQueue {
    private final ArrayDeque<Departure> leaving = new ArrayDeque<>();

    void add(Line to, char character, double seconds) {
        leaving.add(new Departure(to, character, seconds));
    }

    /** Sends the characters whose transmission has ended, in one message for each line. */
    void sendUntil(double now) {
        if (!isDue(now)) {
            return;
        }
        Map<Line, StringBuilder> messages = new LinkedHashMap<>();
        while (isDue(now)) {
            Departure next = leaving.remove();
            messages.computeIfAbsent(next.to(), line -> new StringBuilder()).append(next.character());
        }
        messages.forEach((line, message) -> line.send(message.toString().getBytes(StandardCharsets.ISO_8859_1)));
    }

    boolean isEmpty() {
        return leaving.isEmpty();
    }

    void clear() {
        leaving.clear();
    }

    private boolean isDue(double now) {
        Departure first = leaving.peek();
        return first != null && first.seconds() <= now;
    }

    private record Departure(Line to, char character, double seconds) {}
}
