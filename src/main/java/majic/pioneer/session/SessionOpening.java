package majic.pioneer.session;

import java.util.Arrays;
import java.util.function.BooleanSupplier;
import majic.bot.BotException;
import majic.bot.Pose;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.state.Ramps;
import majic.pioneer.state.Side;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * Opens the line and begins a session: handshake, OPEN, CONFIG, speed of the line, ramps, reports, sonar
 * (ARCOS sheet 13.1), without moving anything or switching motors on. Runs on the thread that connects, once for each
 * session.
 */
final class SessionOpening {
    private static final double FIRST_SIP_S = 2;
    private static final double CONFIG_S = 0.2;
    private static final int CONFIG_TRIES = 5;
    private static final double SONAR_CYCLE_S = 1;

    private final PioneerSession session;
    private final ArcosLine line;
    private final PacketInbox inbox;
    private final ConnectWait wait;
    private final TimeSource time;

    SessionOpening(PioneerSession session, ArcosLine line, PacketInbox inbox, ConnectWait wait, TimeSource time) {
        this.session = session;
        this.line = line;
        this.inbox = inbox;
        this.wait = wait;
        this.time = time;
    }

    /**
     * Opens the session. Leaves nothing open when it throws.
     *
     * @param start the pose that the odometry begins with
     * @param ramps those that a user has set; null for the careful ones. Reduced to the robot's limits, then sent
     * @throws ArcosHandshake.SessionClosed if a second attempt will succeed
     * @throws BotException if there is no Pioneer, or it sends no SIP
     */
    void run(Pose start, @Nullable Ramps ramps) {
        line.open(session);
        try {
            BaudRates rates = new BaudRates(line);
            session.begin(new ArcosHandshake(line, inbox, rates, time).run(), start);
            startSips();
            requestConfig();
            session.autobaud().run(session.config(), rates.now());
            session.use(ramps);
            session.subscriptions().begin(session.config());
            startSonar();
        } catch (RuntimeException e) {
            session.close();
            throw e;
        }
    }

    /** Requests the first CONFIG together with OPEN, so that its answer comes while the first SIP is awaited. */
    private void startSips() {
        line.send(ArcosCommand.OPEN.packet(1), ArcosCommand.CONFIG.packet(1));
        require(session::hasReported, FIRST_SIP_S, "answered the handshake, but sends no data within 2 s");
    }

    private void requestConfig() {
        for (int tries = 1; !await(() -> session.config() != null, CONFIG_S) && tries < CONFIG_TRIES; tries++) {
            line.send(ArcosCommand.CONFIG.packet(1));
        }
    }

    private void startSonar() {
        line.send(ArcosCommand.SONAR.packet(1));
        await(this::hasReadingsOnAllSides, SONAR_CYCLE_S);
        require(() -> !line.hasEnded(), 0, "closed the connection right after the handshake");
    }

    private boolean hasReadingsOnAllSides() {
        return session.hasReported()
                && Arrays.stream(Side.values())
                        .filter(side ->
                                session.equipment().model().discs().stream().anyMatch(side::isCoveredBy))
                        .allMatch(session.state().gaps()::containsKey);
    }

    private boolean await(BooleanSupplier condition, double seconds) {
        wait.await(() -> condition.getAsBoolean() || line.hasEnded(), seconds);
        return condition.getAsBoolean();
    }

    private void require(BooleanSupplier condition, double seconds, String complaint) {
        if (!await(condition, seconds)) {
            throw new BotException(line.address() + " " + complaint);
        }
    }
}
