package majic.team;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import majic.time.Signal;
import majic.time.TimeSource;

/** Calls the listeners of a team, and wakes the threads that wait for a change in it. Thread-safe. */
final class TeamEvents {
    private static final Logger LOG = System.getLogger(TeamEvents.class.getName());

    private final TimeSource time;
    private final Signal changes;
    private final List<TeamListener> listeners = new CopyOnWriteArrayList<>();
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
        listeners.add(listener);
    }

    void remove(TeamListener listener) {
        listeners.remove(listener);
    }

    /** The listeners to the beginning of commands; changes when listeners are added and removed. */
    List<CommandListener> commandListeners() {
        return commandListeners;
    }

    /** Calls all listeners on this thread; one that fails does not keep the others from being called. */
    void publish(Consumer<TeamListener> event) {
        for (TeamListener listener : listeners) {
            try {
                event.accept(listener);
            } catch (RuntimeException | Error e) {
                LOG.log(Level.WARNING, "a listener of the team failed", e);
            }
        }
    }

    void answer(Answer answer) {
        publish(listener -> listener.answered(answer));
    }
}
