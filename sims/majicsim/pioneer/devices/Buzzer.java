package majicsim.pioneer.devices;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;

/** The buzzer: plays tunes in lab time and records the audible notes. */
public final class Buzzer {
    /** SAY takes this many pairs of duration and tone (ARCOS sheet 6.1). */
    private static final int MOST_TONES = 20;

    private static final int KEPT = 200;

    private final Deque<Tone> waiting = new ArrayDeque<>();
    private final Deque<Tone> heard = new ArrayDeque<>();
    private Tone now = new Tone(0, 0);
    private long leftNanos;
    private boolean muted;

    /** SAY: begins this tune in place of the present one; a single byte at the end is ignored. */
    public void say(byte[] pairs) {
        silence();
        for (int i = 0; i + 1 < pairs.length && i < 2 * MOST_TONES; i += 2) {
            waiting.add(Tone.of(pairs[i] & 0xFF, pairs[i + 1] & 0xFF));
        }
        next();
    }

    /** SOUNDTOG. */
    public void mute(boolean on) {
        muted = on;
    }

    /** Ends the tune. */
    void silence() {
        waiting.clear();
        leftNanos = 0;
    }

    void step(long nanos) {
        leftNanos -= nanos;
        while (leftNanos <= 0 && !waiting.isEmpty()) {
            next();
        }
        leftNanos = Math.max(0, leftNanos);
    }

    /** What sounds now, in hertz; 0 if nothing does. */
    public double soundingHertz() {
        return isPlaying() && !muted ? now.hertz() : 0;
    }

    boolean isPlaying() {
        return leftNanos > 0;
    }

    /** The notes that were begun with the sound on, rests too, oldest first; the last 200. */
    public List<Tone> heard() {
        return List.copyOf(heard);
    }

    private void next() {
        if (waiting.isEmpty()) {
            return;
        }
        now = waiting.remove();
        leftNanos += now.durationMs() * 1_000_000L;
        if (!muted) {
            heard.add(now);
            if (heard.size() > KEPT) {
                heard.remove();
            }
        }
    }
}
