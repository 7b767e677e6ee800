package majic.aibo.session;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import majic.aibo.urbi.Tags;
import majic.aibo.urbi.UrbiConnection;
import majic.aibo.urbi.UrbiMessage;
import majic.bot.BotException;
import majic.bot.LinkLost;
import org.jspecify.annotations.Nullable;

/**
 * The command by which the dog sends its microphone's sound, one block of 32 ms each cycle (URBI sheet 8, 13). It runs out by itself
 * on the dog if no stop reaches it. Safe from any thread.
 */
public final class Microphone {
    private static final Logger LOG = System.getLogger(Microphone.class.getName());

    private final UrbiConnection on;
    private final String order;
    private final String stem;
    private final AtomicInteger count = new AtomicInteger();
    private final AtomicReference<@Nullable Ear> ear = new AtomicReference<>();

    /** The receiver and the tag of its blocks: blocks of an earlier recording may still arrive. */
    private record Ear(String tag, Consumer<UrbiMessage> hearer) {}

    Microphone(UrbiConnection on, Tags tags) {
        this.on = on;
        this.order = tags.named("listen");
        this.stem = tags.named("ear");
    }

    /**
     * Begins.
     *
     * @param hearer gets each message on the reader's thread, until {@link #stop}
     * @param longestMs when the dog is to end it by itself
     * @throws BotException if a recording is under way
     */
    public void start(Consumer<UrbiMessage> hearer, long longestMs) {
        String tag = stem + count.incrementAndGet();
        if (!ear.compareAndSet(null, new Ear(tag, hearer))) {
            throw new BotException("the dog is being recorded already; it makes one recording at a time");
        }
        on.send(order + ": timeout(" + longestMs + ") loop { " + on.version().labelled(tag, "micro.val") + " },");
    }

    /** Ends it on the dog; what is on its way still goes nowhere. */
    public void stop() {
        ear.set(null);
        try {
            on.send(stopCommand());
        } catch (LinkLost e) {
            LOG.log(Level.DEBUG, "the microphone's order ends with its connection", e);
        }
    }

    /** What ends the order, if there is one. */
    String stopCommand() {
        return "stop " + order + ",";
    }

    /** Takes a message if it is of the microphone. */
    boolean hears(UrbiMessage message) {
        if (!message.tag().startsWith(stem)) {
            return false;
        }
        Ear open = ear.get();
        if (open != null && open.tag().equals(message.tag())) {
            open.hearer().accept(message);
        }
        return true;
    }
}
