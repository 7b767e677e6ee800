package majic.shared;

import java.util.UUID;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.driver.RobotWait;
import majic.shared.message.RequestReply;
import org.jspecify.annotations.Nullable;

/**
 * The stops of one shared robot: each is published twice, first as fast as possible, then so that it is delivered for
 * certain and answered. Thread-safe.
 */
final class RemoteStop {
    private static final double REPEAT_S = 1;
    private static final double CONFIRM_S = 5;

    private final Supplier<RobotCommands> commands;
    private final RobotWait waiting;
    private final String title;
    private final AtomicReference<@Nullable String> ahead = new AtomicReference<>();
    private volatile @Nullable Sent last;

    /** A stop that was published for certain, and its answer. */
    private record Sent(String id, PendingReply reply) {}

    /**
     * Stops a robot.
     *
     * @param commands publish to it
     * @param title of the robot in messages
     */
    RemoteStop(Supplier<RobotCommands> commands, RobotWait waiting, String title) {
        this.commands = commands;
        this.waiting = waiting;
        this.title = title;
    }

    /** Forgets the stops of an earlier connection, whose answers will not arrive. */
    void reset() {
        ahead.set(null);
        last = null;
    }

    /** Publishes the first copy of a stop. Waits for nothing. */
    void sendAhead() {
        String id = UUID.randomUUID().toString();
        ahead.set(id);
        commands.get().stopAhead(id);
    }

    /** Returns whether a stop of this program is on its way, or was not answered yet. */
    boolean isPending() {
        Sent sent = last;
        return isAhead() || sent != null && !sent.reply().isDone();
    }

    /** Returns whether a first copy was published whose second one is missing. */
    boolean isAhead() {
        return ahead.get() != null;
    }

    /** Publishes the second copy of the stop, and the first one if there is none. Waits for nothing. */
    void send() {
        String id = ahead.getAndSet(null);
        if (id == null) {
            id = UUID.randomUUID().toString();
            commands.get().stopAhead(id);
        }
        publish(id);
    }

    private Sent publish(String id) {
        Sent before = last;
        Sent sent = new Sent(id, commands.get().stopConfirmed(id));
        last = sent;
        if (before != null) {
            commands.get().forget(before.reply());
        }
        return sent;
    }

    /**
     * Waits until the desk has confirmed the last stop, if there is one to be confirmed, and publishes it again each
     * second.
     *
     * @throws BotException if it is not confirmed within 5 s, or failed
     */
    void confirm() {
        for (double waited = 0; waited < CONFIRM_S; waited += REPEAT_S) {
            Sent sent = last;
            if (sent == null
                    || waiting.await(
                            () -> sent.reply().isDone() || commands.get().isOver(), REPEAT_S)) {
                check(sent);
                return;
            }
            publish(sent.id());
        }
        last = null;
        throw new BotException("the stop of " + title + " was not confirmed within " + Math.round(CONFIRM_S) + " s");
    }

    private void check(@Nullable Sent sent) {
        last = null;
        if (sent == null) {
            return;
        }
        commands.get().forget(sent.reply());
        RequestReply end = sent.reply().end();
        if (end == null) {
            throw new LinkLost("the connection to " + title + " was lost before its stop was confirmed");
        }
        switch (end.outcome()) {
            case DONE, ACCEPTED -> {}
            case LOST -> throw new LinkLost(end.message());
            case STOPPED, REFUSED, FAILED -> throw new BotException(end.message());
        }
    }
}
