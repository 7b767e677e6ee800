package majic.pioneer.line;

import java.util.concurrent.ConcurrentLinkedQueue;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.pioneer.arcos.Packet;
import majic.pioneer.session.ConnectWait;
import org.jspecify.annotations.Nullable;

/** Queues the packets received during the handshake for the thread that connects. */
final class PacketInbox {
    private final ConcurrentLinkedQueue<Packet> packets = new ConcurrentLinkedQueue<>();
    private final ConnectWait wait;
    private volatile @Nullable LinkLost end;

    PacketInbox(ConnectWait wait) {
        this.wait = wait;
    }

    void put(Packet packet) {
        packets.add(packet);
        wait.raise();
    }

    void end(LinkLost cause) {
        end = cause;
        wait.raise();
    }

    /**
     * Waits for the next packet.
     *
     * @return null when none came in time
     * @throws LinkLost if the line ended and all packets are read
     * @throws BotException if the connection attempt is canceled
     */
    @Nullable
    Packet next(double seconds) {
        wait.await(() -> !packets.isEmpty() || end != null, seconds);
        Packet packet = packets.poll();
        LinkLost cause = end;
        if (packet == null && cause != null) {
            throw new LinkLost(cause.getMessage(), cause);
        }
        return packet;
    }
}
