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
 * The command by which the dog sends its microphone's sound, one block of 32 ms each cycle (URBI sheet 8, 13). It ends
 * by itself on the dog if no stop arrives. Safe from any thread.
 */
public final class Microphone {
    private static final Logger LOG = System.getLogger(Microphone.class.getName());

    private final UrbiConnection on;
    private final String command;
    private final String stem;
    private final AtomicInteger count = new AtomicInteger();
    private final AtomicReference<@Nullable Recording> recording = new AtomicReference<>();

    /** The receiver and the tag of its blocks: blocks of an earlier recording may still arrive. */
    private record Recording(String tag, Consumer<UrbiMessage> receiver) {}

    Microphone(UrbiConnection on, Tags tags) {
        this.on = on;
        this.command = tags.named("listen");
        this.stem = tags.named("ear");
    }

    /**
     * Begins.
     *
     * @param receiver takes each message on the reader thread, until {@link #stop}
     * @param longestMs after this time the dog ends it by itself, ms
     * @throws BotException if a recording is under way
     */
    public void start(Consumer<UrbiMessage> receiver, long longestMs) {
        String tag = stem + count.incrementAndGet();
        if (!recording.compareAndSet(null, new Recording(tag, receiver))) {
            throw new BotException("the dog is being recorded already; it makes one recording at a time");
        }
        on.send(command + ": timeout(" + longestMs + ") loop { " + on.version().labelled(tag, "micro.val") + " },");
    }

    /** Ends it on the dog; blocks that arrive later are dropped. */
    public void stop() {
        recording.set(null);
        try {
            on.send(stopCommand());
        } catch (LinkLost e) {
            LOG.log(Level.DEBUG, "the microphone's command ends with its connection", e);
        }
    }

    /** The command that ends it, if it runs. */
    String stopCommand() {
        return "stop " + command + ",";
    }

    /** Takes a message if it is from the microphone; returns whether it is. */
    boolean take(UrbiMessage message) {
        if (!message.tag().startsWith(stem)) {
            return false;
        }
        Recording open = recording.get();
        if (open != null && open.tag().equals(message.tag())) {
            open.receiver().accept(message);
        }
        return true;
    }
}
