package majicsim.hemisson;

import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import majicsim.net.Line;

/** Characters on their way out, each with the time at which it has left. */
final class Outbox {
    private final ArrayDeque<Departure> leaving = new ArrayDeque<>();

    void add(Line to, char character, double seconds) {
        leaving.add(new Departure(to, character, seconds));
    }

    /** What has left by now goes out, in one message for each line. */
    void sendUntil(double now) {
        while (isDue(now)) {
            Line to = leaving.element().to();
            StringBuilder message = new StringBuilder();
            while (isDue(now) && leaving.element().to() == to) {
                message.append(leaving.remove().character());
            }
            to.send(message.toString().getBytes(StandardCharsets.ISO_8859_1));
        }
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
