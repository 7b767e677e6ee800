package majicsim.aibo.urbi.memory;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/**
 * The events that programs emit (URBI sheet, section 8). One is seen for a whole cycle at least, by every handler
 * alike; the next of the same name comes a cycle after it, so that handlers see the edge between them.
 */
public final class Events {
    /** More events of one name than this do not wait for their turn. */
    private static final int MAX_WAITING = 1000;

    /** One event as it was emitted; its time runs from the cycle in which it is seen first. */
    public record Event(List<Value> arguments, double durationMs) {}

    private static final class Channel {
        private final Deque<Event> waiting = new ArrayDeque<>();
        private @Nullable Event current;
        private double endMs;

        private void turn(double nowMs, double cycleMs) {
            if (current != null && nowMs >= endMs) {
                current = null;
            } else if (current == null && !waiting.isEmpty()) {
                Event next = waiting.remove();
                current = next;
                endMs = nowMs + Math.max(next.durationMs(), cycleMs);
            }
        }
    }

    private final double cycleMs;
    private final Set<String> declared = new HashSet<>();
    private final Map<String, Channel> channels = new HashMap<>();

    /** @param cycleMs how long an event is seen at least */
    Events(double cycleMs) {
        this.cycleMs = cycleMs;
    }

    public void declare(String name) {
        declared.add(name);
    }

    public boolean isKnown(String name) {
        return declared.contains(name) || channels.containsKey(name);
    }

    public int count() {
        return declared.size() + channels.size();
    }

    public void emit(String name, Event event) {
        Channel channel = channels.computeIfAbsent(name, any -> new Channel());
        if (channel.waiting.size() < MAX_WAITING) {
            channel.waiting.add(event);
        }
    }

    /** The event of that name that is seen in this cycle. */
    public @Nullable Event current(String name) {
        Channel channel = channels.get(name);
        return channel == null ? null : channel.current;
    }

    /** To be called once a cycle, before any handler looks. */
    public void turn(double nowMs) {
        channels.values().forEach(channel -> channel.turn(nowMs, cycleMs));
    }

    public void remove(String name) {
        declared.remove(name);
        channels.remove(name);
    }

    void removeAllOf(String prefix) {
        declared.removeIf(name -> name.startsWith(prefix));
        channels.keySet().removeIf(name -> name.startsWith(prefix));
    }
}
