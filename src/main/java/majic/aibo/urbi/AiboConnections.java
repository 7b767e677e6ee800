package majic.aibo.urbi;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.bot.LinkLost;
import majic.driver.RobotWait;
import majic.text.Advice;
import org.jspecify.annotations.Nullable;

/**
 * The three connections to one dog: for motion, for sensors and settings, and for stops only, so that a stop never
 * waits behind another command. If one breaks, all end: commands that are not yet sent are discarded, so that no walk
 * reaches the dog late, and a stop is sent over a remaining connection.
 */
public final class AiboConnections {
    private static final Logger LOG = System.getLogger(AiboConnections.class.getName());
    private static final int OPEN_TIMEOUT_MS = 4000;
    private static final double IDENT_TIMEOUT_S = 4;
    private static final double CLOSING_S = 1;
    private static final String NEW_ADDRESS =
            " A router may have given it another address; Search the network in Add Bot finds it.";

    private final RobotWait waiting;
    private final UrbiConnection motion;
    private final UrbiConnection sensors;
    private final UrbiConnection stop;
    private final Consumer<LinkLost> whenLost;
    private @Nullable String brokenBecause;
    private boolean opened;

    public AiboConnections(
            Supplier<UrbiTransport> transport,
            RobotWait waiting,
            Consumer<UrbiMessage> listener,
            Consumer<LinkLost> whenLost) {
        this.waiting = waiting;
        this.whenLost = whenLost;
        Function<String, UrbiConnection> make =
                purpose -> new UrbiConnection(purpose, transport.get(), waiting, listener, this::broken);
        this.motion = make.apply("motion");
        this.sensors = make.apply("sensors");
        this.stop = make.apply("stop");
    }

    public UrbiConnection motion() {
        return motion;
    }

    public UrbiConnection sensors() {
        return sensors;
    }

    public UrbiConnection stop() {
        return stop;
    }

    /** Opens all three and waits until the dog has identified itself on each. Leaves nothing open when it throws. */
    public void open() {
        try {
            for (UrbiConnection connection : all()) {
                open(connection);
            }
        } catch (BotException e) {
            abort();
            throw e;
        }
    }

    private void open(UrbiConnection connection) {
        try {
            connection.open(OPEN_TIMEOUT_MS);
            waiting.awaitConnecting(() -> connection.isIdentified() || connection.isEnded(), IDENT_TIMEOUT_S);
        } catch (IOException e) {
            throw granted() > 0
                    ? tooFew(e)
                    : ConnectFailed.of(
                            e,
                            Advice.joined(
                                            String.valueOf(e.getMessage()),
                                            "is the dog on, in the network, and URBI on its stick?")
                                    + NEW_ADDRESS);
        }
        if (connection.isEnded() || !connection.isIdentified()) {
            throw granted() > 0 ? tooFew(null) : refusal(connection);
        }
    }

    private long granted() {
        return all().stream().filter(UrbiConnection::isIdentified).count();
    }

    /**
     * If the dog has identified itself on one connection, the address is right, but the dog has no room for another
     * client.
     */
    private ConnectFailed tooFew(@Nullable IOException cause) {
        return new ConnectFailed(
                Reason.BUSY,
                "the dog grants only " + granted() + " of the three connections that it takes to drive and stop it; "
                        + "end other programs that use it, or restart it",
                cause);
    }

    private static ConnectFailed refusal(UrbiConnection connection) {
        String said = connection.foreignText();
        if (connection.isEnded() && said == null) {
            return new ConnectFailed(
                    Reason.BUSY, "the dog closed the connection at once; are there too many clients connected to it?");
        }
        return new ConnectFailed(
                Reason.WRONG_DEVICE,
                "something answers there, but not as an URBI server within " + (int) IDENT_TIMEOUT_S + " s"
                        + (said == null ? "" : "; it says \"" + said + "\"")
                        + "; is this the dog, and is 54000 the right port?" + NEW_ADDRESS);
    }

    /**
     * Reports a broken connection to the listener from now on.
     *
     * @throws BotException if one has broken before
     */
    public void announceOpened() {
        synchronized (this) {
            opened = brokenBecause == null;
        }
        if (!opened) {
            throw new BotException("the connection broke while it was being set up: " + brokenBecause);
        }
    }

    /** Ends all connections because one is broken, and reports that once; does nothing the second time. */
    public void broken(UrbiConnection connection, String why) {
        boolean report;
        synchronized (this) {
            if (brokenBecause != null) {
                return;
            }
            brokenBecause = why;
            report = opened;
        }
        stopQuietly(connection == stop ? sensors : stop);
        if (report) {
            whenLost.accept(new LinkLost("connection lost: " + why));
        }
        waiting.changes().raise();
    }

    /** Discards what is not yet sent, and sends a stop over the one connection that may still reach the dog. */
    private void stopQuietly(UrbiConnection last) {
        all().stream().filter(connection -> connection != last).forEach(UrbiConnection::abort);
        try {
            last.send(UrbiCommands.STOP_GAITS);
        } catch (LinkLost e) {
            LOG.log(Level.DEBUG, "no stop could be sent over a broken connection", e);
        }
        last.close();
    }

    /** Ends everything at once. */
    public void abort() {
        all().forEach(UrbiConnection::abort);
    }

    /** Sends the closing commands on the stop connection, quits on all, and closes; takes 1 s at most. */
    public void close(String closingCommands) {
        all().forEach(UrbiConnection::expectEnd);
        AtomicInteger left = new AtomicInteger(all().size());
        for (UrbiConnection connection : all()) {
            String commands = connection == stop ? closingCommands + " quit;" : "quit;";
            waiting.time()
                    .thread("aibo closing", () -> sendAndClose(connection, commands, left))
                    .start();
        }
        if (!waiting.awaitClosing(() -> left.get() == 0, CLOSING_S)) {
            abort();
        }
    }

    private void sendAndClose(UrbiConnection connection, String commands, AtomicInteger left) {
        try {
            connection.send(commands);
        } catch (LinkLost e) {
            LOG.log(Level.DEBUG, "no closing commands over a broken connection", e);
        } finally {
            connection.close();
            left.decrementAndGet();
            waiting.changes().raise();
        }
    }

    private List<UrbiConnection> all() {
        return List.of(stop, sensors, motion);
    }
}
