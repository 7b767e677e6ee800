package majic.team;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import majic.text.LateLogger;
import majic.time.OrderedEvents;
import majic.time.Signal;
import majic.time.TimeSource;

/**
 * Calls the listeners of a team, and wakes the threads that wait for a change in it. Events about stops are put into a
 * queue for each listener: a listener that blocks does not keep the others from the events that follow. Thread-safe.
 */
final class TeamEvents {
    private static final Logger LOG = LateLogger.of(TeamEvents.class);

    private final TimeSource time;
    private final Signal changes;
    private final List<Receiver> receivers = new CopyOnWriteArrayList<>();
    private final List<CommandListener> commandListeners = new CopyOnWriteArrayList<>();

    /**
     * @param time the clock of the team
     * @param changes the signal that is raised after a change
     */
    TeamEvents(TimeSource time, Signal changes) {
        this.time = time;
        this.changes = changes;
    }

    /** The clock of the team, which may differ from a robot's. */
    TimeSource time() {
        return time;
    }

    /** The signal to raise after a change, with no lock held. */
    Signal changes() {
        return changes;
    }

    void add(TeamListener listener) {
        receivers.add(new Receiver(listener, new OrderedEvents()));
    }

    void remove(TeamListener listener) {
        receivers.stream()
                .filter(receiver -> receiver.listener.equals(listener))
                .findFirst()
                .ifPresent(receivers::remove);
    }

    /** The listeners to the beginning of commands; changes when listeners are added and removed. */
    List<CommandListener> commandListeners() {
        return commandListeners;
    }

    /** Calls all listeners on this thread; one that fails does not keep the others from being called. */
    void publish(Consumer<TeamListener> event) {
        receivers.forEach(receiver -> receiver.call(event));
    }

    /** Queues an event for all listeners, in order with the others that are queued; calls none. */
    void put(Consumer<TeamListener> event) {
        put(event, () -> {});
    }

    /**
     * Queues an event for all listeners, in order with the others that are queued; calls none.
     *
     * @param afterwards runs when every listener has returned from it
     */
    void put(Consumer<TeamListener> event, Runnable afterwards) {
        List<Receiver> present = List.copyOf(receivers);
        AtomicInteger open = new AtomicInteger(present.size());
        if (present.isEmpty()) {
            afterwards.run();
        }
        present.forEach(receiver -> receiver.events.put(() -> {
            receiver.call(event);
            if (open.decrementAndGet() == 0) {
                afterwards.run();
            }
        }));
    }

    /**
     * Calls the listeners for the queued events, on this thread; leaves out a listener that another thread is calling.
     */
    void deliver() {
        receivers.forEach(receiver -> receiver.events.deliver());
    }

    void answer(Answer answer) {
        publish(listener -> listener.answered(answer));
    }

    /** A listener, with the events that it has not received yet. */
    private record Receiver(TeamListener listener, OrderedEvents events) {
        void call(Consumer<TeamListener> event) {
            try {
                event.accept(listener);
            } catch (RuntimeException | Error e) {
                LOG.log(Level.WARNING, "a listener of the team failed", e);
            }
        }
    }
}
