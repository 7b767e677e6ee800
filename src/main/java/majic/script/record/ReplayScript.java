package majic.script.record;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Writes what was done in a session as a script that does it again. Robots that had finished before another was started
 * are waited for; otherwise time decides. A motion that was stopped is replayed by time alone, from its beginning to
 * the stop, so that it ends no later than it did.
 */
final class ReplayScript {
    private static final long NANOS_PER_MS = 1_000_000;
    private static final long SHORTEST_PAUSE_MS = 100;

    private final List<String> lines = new ArrayList<>();
    private long reachedNanos;
    private boolean begun;

    private ReplayScript() {}

    /**
     * Writes the script.
     *
     * @param events in the order of their times
     * @return its lines
     */
    static List<String> of(List<SessionRecord.Event> events) {
        List<SessionRecord.Event> folded = fold(events);
        List<Set<Integer>> stopped = stoppedLater(folded);
        ReplayScript script = new ReplayScript();
        for (int index = 0; index < folded.size(); index++) {
            script.add(folded.get(index), stopped.get(index));
        }
        return script.lines;
    }

    private static List<SessionRecord.Event> fold(List<SessionRecord.Event> events) {
        Map<RecordedBlock, List<SessionRecord.Event>> blocks = new LinkedHashMap<>();
        for (SessionRecord.Event event : events) {
            if (event.block() != null) {
                blocks.computeIfAbsent(event.block(), block -> new ArrayList<>())
                        .add(event);
            }
        }
        blocks.keySet().removeIf(block -> !block.standsForItself(events));
        List<SessionRecord.Event> folded = new ArrayList<>();
        for (SessionRecord.Event event : events) {
            List<SessionRecord.Event> its = event.block() == null ? null : blocks.get(event.block());
            if (its == null) {
                folded.add(event);
            } else if (its.get(0) == event) {
                folded.add(event.block().inPlaceOf(its));
            }
        }
        return folded;
    }

    /** For each event the robots that have something to do when it has been done, and are stopped before they end. */
    private static List<Set<Integer>> stoppedLater(List<SessionRecord.Event> events) {
        List<Set<Integer>> all = new ArrayList<>();
        Set<Integer> stopped = new HashSet<>();
        for (int index = events.size() - 1; index >= 0; index--) {
            SessionRecord.Event event = events.get(index);
            all.add(0, Set.copyOf(stopped));
            if (event.kind() == SessionRecord.Event.Kind.STOP) {
                stopped.addAll(event.begins());
            } else {
                stopped.removeAll(event.kind() == SessionRecord.Event.Kind.WAIT ? event.robots() : event.begins());
                stopped.removeAll(event.finished().keySet());
            }
        }
        return all;
    }

    private void add(SessionRecord.Event event, Set<Integer> stoppedLater) {
        boolean untimed = event.begins().containsAll(stoppedLater) && event.kind() != SessionRecord.Event.Kind.STOP;
        if (event.kind() == SessionRecord.Event.Kind.WAIT) {
            if (stoppedLater.isEmpty()) {
                await(event.text(), event.atNanos());
            }
            return;
        }
        if (untimed && !event.finished().isEmpty()) {
            long last = event.finished().values().stream()
                    .mapToLong(Long::longValue)
                    .max()
                    .orElseThrow();
            await(SessionRecord.names(event.finished().keySet()) + " wait", last);
        }
        if (event.kind() == SessionRecord.Event.Kind.ADD) {
            reachedNanos = Math.max(reachedNanos, event.atNanos());
        } else {
            pause(event, stoppedLater.isEmpty() && untimed ? SHORTEST_PAUSE_MS : 1);
        }
        lines.addAll(event.text().lines().toList());
        if (event.kind() == SessionRecord.Event.Kind.BLOCK) {
            end(event);
        }
    }

    private void end(SessionRecord.Event event) {
        RecordedBlock block = event.block();
        if (block == null) {
            return;
        }
        reachedNanos = Math.max(reachedNanos, block.endedNanos());
        if (block.hasFinished() && !event.robots().isEmpty()) {
            lines.add(SessionRecord.names(event.robots()) + " wait");
        }
    }

    private void await(String line, long finishedNanos) {
        lines.add(line);
        reachedNanos = Math.max(reachedNanos, finishedNanos);
    }

    /** Pauses that are too short are made up for by the next. What was done before anything else begins at once. */
    private void pause(SessionRecord.Event event, long shortestMs) {
        long pauseMs = (event.atNanos() - reachedNanos) / NANOS_PER_MS;
        if (!begun) {
            begun = true;
            reachedNanos = event.atNanos();
        } else if (pauseMs >= shortestMs) {
            lines.add("wait "
                    + BigDecimal.valueOf(pauseMs, 3).stripTrailingZeros().toPlainString() + "s");
            reachedNanos += pauseMs * NANOS_PER_MS;
        }
    }
}
