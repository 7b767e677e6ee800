package majic.bot;

import java.util.ArrayDeque;
import java.util.Locale;
import java.util.Queue;
import java.util.function.Consumer;
import majic.bot.MajicBot.Connection;
import org.jspecify.annotations.Nullable;

/**
 * How the connection of one robot comes and goes. Each change is told in its order and by one thread at a time, but with
 * no lock in hand: who listens may wait for somebody who closes the robot. Thread-safe.
 */
final class ConnectionLife {
    private final Consumer<Connection> listener;
    private final Queue<Connection> untold = new ArrayDeque<>();
    private boolean telling;
    private volatile Connection now = Connection.NEW;
    private volatile @Nullable LinkLost lostBecause;

    /**
     * A robot's that nobody has connected yet.
     *
     * @param listener hears of each change, on the thread that made it or on the one that tells of an earlier one; throws
     *     nothing
     */
    ConnectionLife(Consumer<Connection> listener) {
        this.listener = listener;
    }

    Connection now() {
        return now;
    }

    /** How the connection was lost; null also after an attempt to connect that came to nothing. */
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
    boolean begin(String name) {
        boolean first;
        synchronized (this) {
            if (now != Connection.NEW && now != Connection.LOST) {
                throw new BotException(name + " is " + now.name().toLowerCase(Locale.ROOT));
            }
            first = now == Connection.NEW;
            lostBecause = null;
            become(Connection.CONNECTING);
        }
        tell();
        return first;
    }

    /** Takes the outcome of connecting; false if the robot was closed meanwhile, and then stays so. */
    boolean end(Connection outcome) {
        boolean open;
        synchronized (this) {
            if (now == Connection.CONNECTING) {
                become(outcome);
            }
            open = now != Connection.CLOSED;
        }
        tell();
        return open;
    }

    /**
     * Takes note that the link broke.
     *
     * @param cause how
     * @param first done before anybody can connect again
     * @return false if there was no connection to lose
     */
    boolean lose(LinkLost cause, Runnable first) {
        synchronized (this) {
            if (now != Connection.CONNECTED && now != Connection.CONNECTING) {
                return false;
            }
            lostBecause = cause;
            first.run();
            become(Connection.LOST);
        }
        tell();
        return true;
    }

    /**
     * Ends it for good. Listeners hear of it at the next {@link #tell()}, after the robot was stopped.
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
        untold.add(next);
    }

    /** Tells the listener of all changes that it has not heard of. */
    void tell() {
        for (Connection next = firstUntold(); next != null; next = nextUntold()) {
            listener.accept(next);
        }
    }

    /** Null also while somebody else is telling: he goes on with it. */
    private synchronized @Nullable Connection firstUntold() {
        return telling ? null : nextUntold();
    }

    private synchronized @Nullable Connection nextUntold() {
        Connection next = untold.poll();
        telling = next != null;
        return next;
    }
}
