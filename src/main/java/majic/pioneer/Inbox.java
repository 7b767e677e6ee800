package majic.pioneer;

import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.BooleanSupplier;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.Signal;
import majic.pioneer.arcos.Packet;
import org.jspecify.annotations.Nullable;

/** Where packets wait while the connection is being made, and who waits for them. */
final class Inbox {
    private final ConcurrentLinkedQueue<Packet> packets = new ConcurrentLinkedQueue<>();
    private final Signal changes;
    private final BooleanSupplier givenUp;
    private volatile @Nullable LinkLost end;

    /**
     * An empty one.
     *
     * @param changes raised by whoever puts something in or gives up
     * @param givenUp whether nobody wants the connection any more
     */
    Inbox(Signal changes, BooleanSupplier givenUp) {
        this.changes = changes;
        this.givenUp = givenUp;
    }

    void put(Packet packet) {
        packets.add(packet);
        changes.raise();
    }

    void end(LinkLost cause) {
        end = cause;
        changes.raise();
    }

    /**
     * Waits for the next packet.
     *
     * @return null when none came in time
     * @throws LinkLost if the line ended and all packets are read
     * @throws BotException if the connection is not wanted any more
     */
    @Nullable
    Packet next(double seconds) {
        await(() -> !packets.isEmpty() || end != null, seconds);
        Packet packet = packets.poll();
        LinkLost cause = end;
        if (packet == null && cause != null) {
            throw new LinkLost(cause.getMessage(), cause);
        }
        return packet;
    }

    private void await(BooleanSupplier news, double seconds) {
        try {
            changes.await(() -> news.getAsBoolean() || givenUp.getAsBoolean(), seconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new BotException("interrupted while connecting", e);
        }
        if (givenUp.getAsBoolean()) {
            throw new BotException("closed while connecting");
        }
    }
}
