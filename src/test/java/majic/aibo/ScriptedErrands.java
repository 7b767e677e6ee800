package majic.aibo;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import majic.bot.Agenda;
import majic.time.TimeSource;

/**
 * What goes on in a scripted dog for a time: gaits, postures, reports. A gait goes by its own name, the rest by its
 * tag.
 */
final class ScriptedErrands {
    private final Agenda agenda;
    private final Map<String, Agenda.Event> running = new ConcurrentHashMap<>();
    private final Map<String, Runnable> endings = new ConcurrentHashMap<>();
    private final AtomicInteger mostAtOnce = new AtomicInteger();

    ScriptedErrands(TimeSource time) {
        agenda = new Agenda(time);
    }

    /** Does something once, later. */
    void later(long ms, Runnable task) {
        agenda.after(ms, task);
    }

    /** Does something again and again, until it is stopped. */
    void repeat(String name, long periodMs, Runnable task) {
        running.put(name, agenda.every(periodMs, task));
    }

    /**
     * Begins something that takes its time.
     *
     * @param whenOver done when it has ended by itself
     * @param whenStopped done where it is a gait that is stopped before
     */
    void begin(String name, long lastsMs, Runnable whenOver, Runnable whenStopped) {
        long others = Stream.of("walk", "turn").filter(this::isUnderWay).count();
        endings.put(name, whenStopped);
        running.put(name, agenda.after(lastsMs, whenOver));
        if (isGait(name)) {
            mostAtOnce.accumulateAndGet((int) others + 1, Math::max);
        }
    }

    /** Ends it early. Only a gait then reports its end (URBI sheet 7, 15). */
    void stop(String name) {
        Agenda.Event stopped = running.remove(name);
        if (stopped != null && stopped.cancel() && isGait(name)) {
            endings.get(name).run();
        }
    }

    boolean hasBegun(String name) {
        return endings.containsKey(name);
    }

    boolean isUnderWay(String name) {
        Agenda.Event errand = running.get(name);
        return errand != null && !errand.isOver();
    }

    int mostAtOnce() {
        return mostAtOnce.get();
    }

    private static boolean isGait(String name) {
        return name.equals("walk") || name.equals("turn");
    }

    void close() {
        agenda.close();
    }
}
