package majic.script.record;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * A block or a file of commands that was run in a session. Where it came to its own end, and nothing else was done
 * meanwhile, it stands for its commands in a saved session. Guarded by the lock of its {@link SessionRecord}.
 */
public final class RecordedBlock {
    private static final int MOST_COMMANDS = 2000;

    private final String text;
    private final long beganNanos;
    private final boolean waits;
    private long endedNanos = Long.MAX_VALUE;
    private boolean completed;
    private boolean dependent;
    private int commands;

    /**
     * A block that begins.
     *
     * @param text the lines that do it again
     * @param beganNanos when it began, on the clock of the team
     * @param waits whether it ends only when its robots have finished
     */
    RecordedBlock(String text, long beganNanos, boolean waits) {
        this.text = text;
        this.beganNanos = beganNanos;
        this.waits = waits;
    }

    /** Ends it; {@code byItself} is whether it came to its own end. */
    void end(long atNanos, boolean byItself) {
        endedNanos = atNanos;
        completed = byItself;
    }

    /**
     * Sets that its text alone does not do it again, since it uses what other lines have defined, a random number, or
     * the answer of a person.
     */
    public void dependsOnOthers() {
        dependent = true;
    }

    /** Counts one more of its commands; false when there are too many to be kept. */
    boolean hasRoom() {
        return ++commands <= MOST_COMMANDS;
    }

    long endedNanos() {
        return endedNanos;
    }

    /** Whether the lines behind it began only after its robots had finished. */
    boolean hasFinished() {
        return waits;
    }

    /** Whether its own text does again what it did. */
    boolean standsForItself(List<SessionRecord.Event> all) {
        return completed && !dependent && all.stream().noneMatch(this::isBeside);
    }

    private boolean isBeside(SessionRecord.Event other) {
        return other.block() != this
                && other.kind() != SessionRecord.Event.Kind.WAIT
                && !other.robots().isEmpty()
                && other.atNanos() > beganNanos
                && other.atNanos() < endedNanos;
    }

    /** The block as one event, in place of its commands, of which there is at least one. */
    SessionRecord.Event inPlaceOf(List<SessionRecord.Event> its) {
        Set<Integer> robots = new LinkedHashSet<>();
        its.forEach(event -> robots.addAll(event.robots()));
        Map<Integer, Long> finished = its.get(0).finished();
        return new SessionRecord.Event(
                SessionRecord.Event.Kind.BLOCK, beganNanos, text, robots, robots, finished, this);
    }
}
