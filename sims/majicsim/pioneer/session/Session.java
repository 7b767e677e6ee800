package majicsim.pioneer.session;

import java.util.List;
import java.util.Locale;
import majicsim.net.Line;
import majicsim.pioneer.board.Board;
import majicsim.pioneer.devices.AuxPort;
import majicsim.pioneer.devices.Devices;
import majicsim.pioneer.motion.Drive;
import majicsim.pioneer.packet.Argument;
import majicsim.pioneer.packet.Packet;
import majicsim.pioneer.packet.PacketReader;
import majicsim.pioneer.packet.PacketWriter;
import majicsim.pioneer.report.ConfigReport;
import majicsim.pioneer.report.Reports;

/**
 * One client's conversation with the board: handshake, commands, watchdog, the packets every 100 ms, and the end (ARCOS
 * sheet 4, 5). On a network line the end closes it; on a serial line it waits for the next handshake.
 */
public final class Session {
    private static final System.Logger LOG = System.getLogger(Session.class.getName());
    private static final long SIP_CYCLE_NANOS = ConfigReport.SIP_CYCLE_MS * 1_000_000L;
    /** How long the rest of a packet may take (ARCOS sheet 14.1). */
    private static final long FRAGMENT_NANOS = 500_000_000L;

    private static final int RESTARTED = 0xFE;

    private final Board board;
    private final boolean hangsUp;
    private final PacketReader reader = new PacketReader();
    private final Handshake handshake;
    private final Line line;
    private Watchdog watchdog;
    private Reports reports;
    private Simulation simulation;
    private boolean open;
    private boolean ended;
    private long sinceSipNanos;
    private long sinceBytesNanos;
    /** The time that has not yet passed on the session, because nothing was due. */
    private long leftNanos;

    private long untilDueNanos;

    public Session(Line line, Board board, boolean hangsUp) {
        this.line = line;
        this.board = board;
        this.hangsUp = hangsUp;
        this.handshake = new Handshake(board.name(), board.model());
        this.watchdog = new Watchdog(board.model().watchdogMs());
        this.reports = new Reports(board);
        this.simulation = newSimulation();
    }

    Board board() {
        return board;
    }

    Drive drive() {
        return board.drive();
    }

    Devices devices() {
        return board.devices();
    }

    /** AUX1 to AUX3, by number. */
    AuxPort aux(int number) {
        return devices().auxPorts().get(number - 1);
    }

    /** The packets that the client receives in each cycle. */
    Reports reports() {
        return reports;
    }

    /** The client's access to the simulator besides the robot. */
    Simulation simulation() {
        return simulation;
    }

    public boolean isOn(Line other) {
        return line == other;
    }

    /** Whether a session is open: after the handshake, before CLOSE. */
    public boolean isUnderWay() {
        return handshake.isComplete();
    }

    /** Whether it has ended and its line is closed. */
    public boolean hasEnded() {
        return ended;
    }

    /** Whether the watchdog has stopped the robot because no packet came. */
    public boolean hasTimedOut() {
        return watchdog.hasExpired();
    }

    public void received(byte[] bytes) {
        trace("<", bytes);
        if (!board.isListening()) {
            return;
        }
        catchUp();
        sinceBytesNanos = 0;
        handle(reader.feed(bytes));
    }

    /** Lets time pass: watchdog, and a SIP each cycle. */
    public void step(long nanos) {
        if (leftNanos + nanos < untilDueNanos) {
            leftNanos += nanos;
            return;
        }
        catchUp();
        pass(nanos);
        untilDueNanos = untilDueNanos();
    }

    /**
     * Lets the time pass in which nothing was due. Called before everything that depends on it, or changes what is due.
     */
    private void catchUp() {
        long nanos = leftNanos;
        leftNanos = 0;
        untilDueNanos = 0;
        pass(nanos);
    }

    private void pass(long nanos) {
        sinceBytesNanos += nanos;
        if (reader.hasFragment() && sinceBytesNanos >= FRAGMENT_NANOS) {
            handle(reader.giveUpFragment());
        }
        if (handshake.step(nanos) && hangsUp) {
            LOG.log(System.Logger.Level.INFO, "pioneer: {0} did not shake hands in 10 s, hanging up", line.peer());
            hangUp();
            return;
        }
        if (isUnderWay() && watchdog.step(nanos)) {
            LOG.log(System.Logger.Level.INFO, "pioneer: no packet for the watchdog''s time, stopping until the next");
            drive().hold(true);
        }
        if (open) {
            reportEachCycle(nanos);
        }
    }

    /** The time until something is due if nothing is received, ns. */
    public long restNanos() {
        return untilDueNanos() - leftNanos;
    }

    private long untilDueNanos() {
        long rest = reader.hasFragment() ? FRAGMENT_NANOS - sinceBytesNanos : Long.MAX_VALUE;
        rest = Math.min(rest, isUnderWay() ? watchdog.restNanos() : handshake.restNanos());
        return open ? Math.min(rest, SIP_CYCLE_NANOS - sinceSipNanos) : rest;
    }

    /** OPEN: starts SIPs and sonar; a second one has no effect. */
    void open() {
        if (!open) {
            open = true;
            sinceSipNanos = 0;
            board.sonar().start();
        }
    }

    /** CLOSE, or the end of the connection: stop, motors off, no more packets. */
    public void close() {
        forgetClient();
        board.endSession();
        if (hangsUp) {
            hangUp();
        }
    }

    private void hangUp() {
        ended = true;
        line.close();
    }

    /** RESET, or the button for it: notifies the client, ends the session and restarts (ARCOS sheet 11.6). */
    public void restart() {
        catchUp();
        send(new PacketWriter(RESTARTED).toBytes());
        forgetClient();
        board.restart();
    }

    /** MAINTENANCE: receives nothing until the reset button is pressed. */
    void maintain() {
        forgetClient();
        board.maintain();
    }

    void send(byte[] packet) {
        trace(">", packet);
        line.send(packet);
    }

    private void handle(List<Packet> packets) {
        for (Packet packet : packets) {
            if (ended || !board.isListening()) {
                return;
            }
            handle(packet);
        }
    }

    private void handle(Packet packet) {
        devices().hostBaud().confirm();
        byte[] greeting = handshake.answer(packet.id());
        if (greeting != null) {
            greet(greeting);
            return;
        }
        if (watchdog.reset()) {
            drive().hold(false);
        }
        Argument argument = new Argument(packet.data());
        if (simulation.take(packet.id(), argument)) {
            return;
        }
        Command.of(packet.id())
                .ifPresentOrElse(
                        command -> command.run(this, argument),
                        () -> LOG.log(System.Logger.Level.DEBUG, "pioneer: ignored command {0}", packet.id()));
    }

    private void forgetClient() {
        open = false;
        handshake.restart();
    }

    private void greet(byte[] greeting) {
        send(greeting);
        if (isUnderWay()) {
            watchdog = new Watchdog(board.model().watchdogMs());
            reports = new Reports(board);
            simulation = newSimulation();
            board.beginSession();
        }
    }

    private Simulation newSimulation() {
        return new Simulation(board, reports, this::send);
    }

    private void reportEachCycle(long nanos) {
        sinceSipNanos += nanos;
        if (sinceSipNanos >= SIP_CYCLE_NANOS) {
            sinceSipNanos -= SIP_CYCLE_NANOS;
            sendAll(reports.next());
            sendAll(simulation.packets());
        }
    }

    private void sendAll(List<byte[]> packets) {
        for (byte[] packet : packets) {
            send(packet);
        }
    }

    private void trace(String direction, byte[] bytes) {
        if (LOG.isLoggable(System.Logger.Level.TRACE)) {
            StringBuilder hex = new StringBuilder();
            for (byte b : bytes) {
                hex.append(String.format(Locale.ROOT, " %02X", b));
            }
            LOG.log(System.Logger.Level.TRACE, "pioneer {0}{1}", direction, hex);
        }
    }
}
