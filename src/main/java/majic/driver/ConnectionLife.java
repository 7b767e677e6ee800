package majic.driver;

import java.util.Locale;
import java.util.function.Consumer;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.MajicBot.Connection;
import org.jspecify.annotations.Nullable;

/** The connection state of one robot. Thread-safe. */
final class ConnectionLife {
    private final Consumer<Connection> changed;
    private volatile Connection now = Connection.NEW;
    private volatile @Nullable LinkLost lostBecause;

    /**
     * Whether an attempt to connect has not ended yet, also after its connection was lost: two would use one robot's
     * link.
     */
    private boolean attempting;

    /**
     * The connection of a robot that has not been connected yet.
     *
     * @param changed takes note of each change, in their order; called with a lock held, so it must notify nothing
     *     itself
     */
    ConnectionLife(Consumer<Connection> changed) {
        this.changed = changed;
    }

    Connection now() {
        return now;
    }

    /** Returns the error that ended the connection; null also after an attempt to connect that came to nothing. */
    @Nullable
    LinkLost lostBecause() {
        return lostBecause;
    }

    /**
     * Begins to connect.
     *
     * @param name what a refusal calls the robot
     * @return whether it is the first time
     * @throws BotException if it is connected, being connected or closed
     */
    synchronized boolean begin(String name) {
        if (attempting) {
            throw new BotException(name + " is already connecting");
        }
        if (now != Connection.NEW && now != Connection.LOST) {
            throw new BotException(name
                    + (now == Connection.CLOSED
                            ? " is closed"
                            : " is already " + now.name().toLowerCase(Locale.ROOT)));
        }
        boolean first = now == Connection.NEW;
        lostBecause = null;
        attempting = true;
        become(Connection.CONNECTING);
        return first;
    }

    /** Takes the outcome of connecting; false if the robot was closed meanwhile, and then stays so. */
    synchronized boolean end(Connection outcome) {
        attempting = false;
        if (now == Connection.CONNECTING) {
            become(outcome);
        }
        return now != Connection.CLOSED;
    }

    /**
     * Records that the connection was lost.
     *
     * @param cause how
     * @param first runs before the robot can be connected again
     * @return false if there was no connection to lose
     */
    synchronized boolean lose(LinkLost cause, Runnable first) {
        if (now != Connection.CONNECTED && now != Connection.CONNECTING) {
            return false;
        }
        lostBecause = cause;
        first.run();
        become(Connection.LOST);
        return true;
    }

    /**
     * Ends it for good. The caller notifies the listeners after the robot was stopped.
     *
     * @param first done before it counts as closed, unless it does already
     * @return what it was before
     */
    synchronized Connection close(Runnable first) {
        Connection before = now;
        if (before != Connection.CLOSED) {
            first.run();
            become(Connection.CLOSED);
        }
        return before;
    }

    private void become(Connection next) {
        now = next;
        changed.accept(next);
    }
}
