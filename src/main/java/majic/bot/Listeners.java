package majic.bot;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;

/**
 * Who is told of a robot; one that fails does not keep the others from hearing. What the robot says before anybody
 * listens, as a warning while it is connected, is kept for the first who does. Thread-safe.
 */
final class Listeners {
    private static final Logger LOG = System.getLogger(Listeners.class.getName());
    private static final int MOST_KEPT = 10;

    private final MajicBot bot;
    private final List<BotListener> all = new CopyOnWriteArrayList<>();
    private final Deque<String> unheard = new ArrayDeque<>();

    Listeners(MajicBot bot) {
        this.bot = bot;
    }

    void add(BotListener listener) {
        List<String> kept;
        synchronized (unheard) {
            all.add(listener);
            kept = List.copyOf(unheard);
            unheard.clear();
        }
        kept.forEach(message -> tell(listener, to -> to.notice(bot, message)));
    }

    void remove(BotListener listener) {
        all.remove(listener);
    }

    /** Passes on what the robot says to the person. */
    void notice(String message) {
        synchronized (unheard) {
            if (all.isEmpty()) {
                keep(message);
                return;
            }
        }
        tell(listener -> listener.notice(bot, message));
    }

    private void keep(String message) {
        if (unheard.size() == MOST_KEPT) {
            unheard.removeFirst();
        }
        unheard.addLast(message);
    }

    void tell(Consumer<BotListener> news) {
        all.forEach(listener -> tell(listener, news));
    }

    private void tell(BotListener listener, Consumer<BotListener> news) {
        try {
            news.accept(listener);
        } catch (RuntimeException | Error e) {
            LOG.log(Level.WARNING, "a listener of " + bot.name() + " failed", e);
        }
    }
}
