package majic.hemisson;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;

/**
 * What only somebody who looks at the robot's tab wants to know: the light that falls on its sensors, and its switches.
 * Asked while somebody looks, and then as seldom as the line needs to stay free for commands; while the robot moves only
 * if an answer takes no longer than {@value #QUICK_MS} ms and no stop is near. Thread-safe; never waits.
 */
final class Spectator {
    /** How often it is looked whether there is something to ask, seconds. */
    static final double PERIOD_S = 0.25;

    private static final double QUICK_MS = 5;

    /** A question here is followed by at least this many times its own time for others. */
    private static final double TIMES_FOR_OTHERS = 8;

    private static final int QUESTIONS_PER_ROUND = 4;

    private final MajicHemisson bot;
    private final AtomicInteger watchers = new AtomicInteger();
    private volatile @Nullable Exchange asked;
    private volatile @Nullable Light light;
    private volatile List<Integer> switches = List.of();
    private int questions;

    /**
     * The light on the eight sensors.
     *
     * @param raw 0 bright to 255 dark, in the order of the robot's answer
     * @param atNanos when it was read
     */
    record Light(List<Integer> raw, long atNanos) {}

    Spectator(MajicHemisson bot) {
        this.bot = bot;
    }

    /** Somebody begins to look. */
    void watch() {
        watchers.incrementAndGet();
    }

    /** Somebody who looked looks away. */
    void leave() {
        watchers.decrementAndGet();
    }

    /** Forgets what another connection told. */
    void begin() {
        asked = null;
        light = null;
        switches = List.of();
    }

    /** The light read last; null before the first. */
    @Nullable
    Light light() {
        return light;
    }

    /** The switches as they are now; those of the time of connecting before the first reading. */
    List<Integer> switches() {
        List<Integer> read = switches;
        return read.isEmpty() ? bot.identity().switches() : read;
    }

    /** Takes in what was answered, and asks the next thing if it is time. Called by the keeper. */
    void tick() {
        Exchange last = asked;
        if (last != null && !last.isDone()) {
            return;
        }
        take(last);
        if (watchers.get() > 0 && bot.isConnected() && hasRested(last) && isLineFree()) {
            asked = bot.conversation().ask(questions++ % QUESTIONS_PER_ROUND == 1 ? Question.SWITCHES : Question.LIGHT);
        }
    }

    private void take(@Nullable Exchange done) {
        Reply reply = done == null ? null : done.reply();
        if (done == null || reply == null) {
            return;
        }
        if (done.question() == Question.LIGHT) {
            light = new Light(List.copyOf(reply.numbers()), done.middleNanos());
        } else {
            switches = List.copyOf(reply.numbers());
        }
    }

    private boolean hasRested(@Nullable Exchange last) {
        double restS = TIMES_FOR_OTHERS * bot.quality().roundTripMs() / 1000;
        return last == null || bot.nanos() - last.sentNanos() > restS * 1e9;
    }

    private boolean isLineFree() {
        return !bot.conversation().mayMove()
                || (bot.quality().roundTripMs() <= QUICK_MS && !bot.overseer().isStopNear());
    }
}
