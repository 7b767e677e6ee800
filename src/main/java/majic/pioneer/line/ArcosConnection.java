package majic.pioneer.line;

import java.util.function.BooleanSupplier;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.bot.LinkLost;
import majic.link.Link;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.LaserChunk;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.PacketCounts;
import majic.pioneer.arcos.Report;
import majic.pioneer.arcos.ReportKind;
import majic.pioneer.arcos.Sip;
import majic.pioneer.session.ConnectWait;
import majic.pioneer.session.PioneerConnection;
import majic.pioneer.session.RobotLine;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * A connection by ARCOS packets: handshake, OPEN, CONFIG, speed of the line (ARCOS sheet 13.1). Packets are decoded on
 * the reader thread of the line.
 */
public final class ArcosConnection implements PioneerConnection, ArcosLine.Listener {
    private static final double FIRST_SIP_S = 2;
    private static final double CONFIG_S = 0.2;
    private static final int CONFIG_TRIES = 5;
    private static final double CLOSING_S = 0.1;

    private final ArcosLine line;
    private final ConnectWait wait;
    private final TimeSource time;
    private final PacketInbox inbox;
    private final Autobaud autobaud;
    private volatile @Nullable Listener listener;
    private volatile @Nullable Config config;

    /** Counted by the reader thread. */
    private volatile int sips;

    /**
     * Creates a connection; opens nothing.
     *
     * @param link not open
     * @param wait of the thread that connects
     */
    public ArcosConnection(Link link, ConnectWait wait) {
        this.time = wait.waiting().time();
        this.line = new ArcosLine(link, time, this);
        this.wait = wait;
        this.inbox = new PacketInbox(wait);
        this.autobaud = new Autobaud(line, () -> sips, wait.waiting());
    }

    /**
     * Connects.
     *
     * @throws ArcosHandshake.SessionClosed if a second attempt will succeed
     */
    @Override
    public void open(Listener opened) {
        line.open();
        BaudRates rates = new BaudRates(line);
        opened.identified(new ArcosHandshake(line, inbox, rates, time).run());
        listener = opened;
        startSips();
        requestConfig();
        autobaud.run(config, rates.now());
    }

    /** Requests the first CONFIG together with OPEN, so that its answer comes while the first SIP is awaited. */
    private void startSips() {
        line.send(ArcosCommand.OPEN.packet(1), ArcosCommand.CONFIG.packet(1));
        if (!await(() -> sips > 0, FIRST_SIP_S)) {
            throw new ConnectFailed(
                    Reason.NO_ANSWER, address() + " answered the handshake, but sends no data within 2 s");
        }
    }

    private void requestConfig() {
        for (int tries = 1; !await(() -> config != null, CONFIG_S) && tries < CONFIG_TRIES; tries++) {
            line.send(ArcosCommand.CONFIG.packet(1));
        }
    }

    private boolean await(BooleanSupplier condition, double seconds) {
        wait.await(() -> condition.getAsBoolean() || line.hasEnded(), seconds);
        return condition.getAsBoolean();
    }

    @Override
    public void received(Packet packet) {
        Listener receiver = listener;
        if (receiver == null) {
            inbox.put(packet);
        } else if (packet.isSip()) {
            Sip sip = Sip.decode(packet);
            if (sip != null) {
                receiver.reported(sip);
                // Last: the thread that waits for the first one reads the state next.
                sips = sips + 1;
                wait.raise();
            }
        } else {
            receiveOther(packet, receiver);
        }
    }

    private void receiveOther(Packet packet, Listener receiver) {
        Report report = ReportKind.decode(packet);
        if (report != null) {
            receiver.reported(report);
        } else if (packet.type() == Config.TYPE) {
            Config decoded = Config.decode(packet);
            receiver.configured(decoded);
            config = decoded;
            wait.raise();
        } else if (packet.isReset()) {
            LinkLost cause = new LinkLost("connection lost: the robot's controller was reset");
            line.abort(cause);
            receiver.ended(cause);
        } else {
            LaserChunk chunk = LaserChunk.decode(packet);
            if (chunk != null) {
                receiver.reported(chunk);
            }
        }
    }

    @Override
    public void ended(LinkLost cause) {
        inbox.end(cause);
        Listener receiver = listener;
        if (receiver != null) {
            receiver.ended(cause);
        }
    }

    @Override
    public RobotLine line() {
        return line;
    }

    @Override
    public String address() {
        return line.address();
    }

    @Override
    public PacketCounts counts() {
        return line.counts();
    }

    @Override
    public void close() {
        if (listener != null) {
            autobaud.restore();
            line.sendIfPossible(ArcosCommand.CLOSE.packet(1));
            // Gives the robot time to act, or to close the connection.
            autobaud.await(line::hasEnded, CLOSING_S);
        }
        line.close();
    }
}
