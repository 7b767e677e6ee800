package majic.pioneer.line;

import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.bot.LinkLost;
import majic.driver.FirstBytes;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.PioneerIdentity;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/** The handshake SYNC0, SYNC1, SYNC2 with the recoveries of ARCOS sheet 4. Runs on the thread that connects. */
public final class ArcosHandshake {
    /** Longer than any SIP cycle, so that an open session is noticed by its SIPs, seconds. */
    private static final double LISTEN_S = 0.25;

    private static final double ANSWER_S = 1;
    private static final double DRAIN_S = 0.2;
    private static final double LIMIT_S = 6;

    /** On a serial port, twice for every speed. */
    private static final double SERIAL_LIMIT_S = 13;

    private static final int LOST_STEP = 0xFF;
    private static final int LAST_SYNC = 2;

    private final ArcosLine line;
    private final PacketInbox inbox;
    private final TimeSource time;
    private final BaudRates rates;
    private double limitS = LIMIT_S;
    private boolean closedASession;

    /** The robot closed the connection along with a session that was left open; a second attempt will succeed. */
    public static final class SessionClosed extends BotException {
        private static final long serialVersionUID = 1;

        private SessionClosed(String message, Throwable cause) {
            super(message, cause);
        }
    }

    ArcosHandshake(ArcosLine line, PacketInbox inbox, BaudRates rates, TimeSource time) {
        this.line = line;
        this.inbox = inbox;
        this.rates = rates;
        this.time = time;
    }

    /**
     * Runs the handshake.
     *
     * @throws SessionClosed if the line ended because an old session was closed
     * @throws BotException if there is no answer, or none of a Pioneer, within {@value #LIMIT_S} s, on a serial port
     *     {@value #SERIAL_LIMIT_S} s
     */
    PioneerIdentity run() {
        try {
            endOpenSession();
            refuseTelnet();
            return synchronise();
        } catch (LinkLost e) {
            throw hungUp(e);
        }
    }

    private BotException hungUp(LinkLost cause) {
        if (closedASession) {
            return new SessionClosed(line.address() + " closed the connection with the session left open on it", cause);
        }
        FirstBytes received = line.firstBytes();
        return received.isWebServer()
                ? new ConnectFailed(
                        Reason.WRONG_DEVICE,
                        ConnectErrors.nothingCameOfIt(line.address(), received, (int) limitS),
                        cause)
                : new ConnectFailed(Reason.BUSY, ConnectErrors.hungUp(line.address(), received), cause);
    }

    /**
     * A robot that sends before the first SYNC is still in a session, perhaps with a velocity in force that it would
     * resume at the SYNC as at any packet. So it is stopped, and the session closed, before.
     */
    private void endOpenSession() {
        long started = time.nanos();
        double leftS = LISTEN_S;
        while (leftS > 0) {
            Packet packet = inbox.next(leftS);
            if (packet != null && packet.isSip()) {
                closeSession();
                return;
            }
            leftS = LISTEN_S - time.secondsSince(started);
        }
    }

    private void refuseTelnet() {
        if (line.firstBytes().isTelnet()) {
            throw new ConnectFailed(Reason.WRONG_DEVICE, ConnectErrors.telnet(line.address()));
        }
    }

    private PioneerIdentity synchronise() {
        long started = time.nanos();
        int step = 0;
        while (time.secondsSince(started) < limitS) {
            line.send(Packet.bare(step));
            Packet answer = inbox.next(ANSWER_S);
            if (answer != null && answer.type() == LAST_SYNC && step == LAST_SYNC) {
                return identity(answer);
            }
            step = answer != null && answer.type() == step ? step + 1 : startOver(answer);
        }
        FirstBytes received = line.firstBytes();
        throw new ConnectFailed(
                received.isEmpty() ? Reason.NO_ANSWER : Reason.WRONG_DEVICE,
                ConnectErrors.nothingCameOfIt(line.address(), received, (int) limitS));
    }

    /** A robot answers the last SYNC with its names; a line that sends back what it receives does not. */
    private PioneerIdentity identity(Packet answer) {
        if (answer.data().length == 0) {
            throw new ConnectFailed(Reason.WRONG_DEVICE, ConnectErrors.echo(line.address()));
        }
        return PioneerIdentity.decode(answer);
    }

    private int startOver(@Nullable Packet answer) {
        if (answer == null) {
            tryNextRate();
        } else if (answer.isSip()) {
            closeSession();
        } else {
            drain(answer.type() == LOST_STEP ? DRAIN_S : DRAIN_S / 2);
        }
        return 0;
    }

    /** Looks for an open session again: its SIPs were noise at the speed before. */
    private void tryNextRate() {
        if (rates.next()) {
            limitS = SERIAL_LIMIT_S;
            endOpenSession();
        }
    }

    private void closeSession() {
        closedASession = true;
        line.send(
                ArcosCommand.ESTOP.packet(),
                ArcosCommand.VEL.packet(0),
                ArcosCommand.RVEL.packet(0),
                ArcosCommand.ENABLE.packet(0),
                ArcosCommand.CLOSE.packet(1));
        drain(DRAIN_S);
    }

    /** Discards packets; answers each SIP of an open session with CLOSE again. */
    private void drain(double seconds) {
        long started = time.nanos();
        Packet packet;
        do {
            packet = inbox.next(Math.max(0, seconds - time.secondsSince(started)));
            if (packet != null && packet.isSip()) {
                closedASession = true;
                line.send(ArcosCommand.CLOSE.packet(1));
            }
        } while (packet != null && time.secondsSince(started) < seconds);
    }
}
