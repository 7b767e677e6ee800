package majic.gui.drive;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Set;

/**
 * Estimates which arrow keys are held down. Must be used on one thread; times are milliseconds of any clock.
 *
 * <p>X11 reports a held key as a sequence of releases and presses, so a release counts only if no press follows soon. A
 * release can also get lost: a held key repeats, so after a time without events no key counts as held. Of two held keys
 * only the later one repeats, and none does once that one is released; then the time without events may be longer.
 */
final class HeldKeys {
    static final long RELEASE_COUNTS_AFTER_MS = 40;
    static final long SILENCE_MS = 1000;
    static final long SILENCE_AFTER_RELEASE_MS = 3000;

    private final Set<Direction> down = EnumSet.noneOf(Direction.class);
    private final Map<Direction, Long> released = new EnumMap<>(Direction.class);
    private long believedUntilMs;

    void press(Direction key, long nowMs) {
        down.add(key);
        released.remove(key);
        believedUntilMs = nowMs + SILENCE_MS;
    }

    void release(Direction key, long nowMs) {
        if (down.contains(key)) {
            released.put(key, nowMs);
        }
    }

    void releaseAll() {
        down.clear();
        released.clear();
    }

    /** Returns the keys held now. */
    Set<Direction> held(long nowMs) {
        released.entrySet().removeIf(entry -> counts(entry.getKey(), entry.getValue(), nowMs));
        if (nowMs >= believedUntilMs) {
            releaseAll();
        }
        return Set.copyOf(down);
    }

    private boolean counts(Direction key, long releasedMs, long nowMs) {
        if (nowMs - releasedMs < RELEASE_COUNTS_AFTER_MS) {
            return false;
        }
        down.remove(key);
        believedUntilMs = releasedMs + SILENCE_AFTER_RELEASE_MS;
        return true;
    }
}
