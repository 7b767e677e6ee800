package majic.pioneer.aria;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.atomic.AtomicBoolean;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.bot.LinkLost;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.PacketCounts;
import majic.pioneer.arcos.Report;
import majic.pioneer.arcos.ReportKind;
import majic.pioneer.arcos.Sip;
import majic.pioneer.session.ConnectWait;
import majic.pioneer.session.PioneerConnection;
import majic.pioneer.session.RobotLine;
import majic.time.SuspendDetector;
import majic.time.TimeSource;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * One connection through ARIA. A thread of its own looks every 10 ms whether ARIA has received another SIP, and reports
 * it; commands are passed on by the calling thread. ARIA's blocking calls run on threads of their own.
 */
final class AriaConnection implements PioneerConnection, RobotLine {
    private static final Logger LOG = System.getLogger(AriaConnection.class.getName());

    private static final double POLL_S = 0.01;

    /** ARIA gives up after 6.4 s without an answer (ARCOS sheet 4), and may try several speeds of a serial port. */
    private static final double CONNECT_S = 30;

    private static final double FIRST_SIP_S = 2;

    /** ARIA takes 1.1 s to disconnect. */
    private static final double DISCONNECT_S = 3;

    private final AriaRobot robot;
    private final AriaDevice device;
    private final ConnectWait wait;
    private final TimeSource time;
    private final SuspendDetector suspend = new SuspendDetector();
    private final AtomicBoolean disconnecting = new AtomicBoolean();
    private final AriaReports reports;
    private volatile @Nullable CompletableFuture<Void> connecting;
    private volatile @Nullable LinkLost end;
    private volatile boolean reported;
    private boolean laserFailed;
    private volatile long sentNanos;

    AriaConnection(AriaRobot robot, AriaDevice device, ConnectWait wait) {
        this.robot = robot;
        this.device = device;
        this.wait = wait;
        this.time = wait.waiting().time();
        this.reports = robot.reports();
    }

    /** What a poll finds. */
    private record News(boolean connected, @Nullable Sip sip, List<Report> others) {}

    @Override
    public void open(Listener listener) {
        try {
            openOnce(listener);
        } catch (LinkageError e) {
            throw failedToConnect(e);
        }
    }

    private void openOnce(Listener listener) {
        if (!wait.await(() -> !robot.isInUse(), DISCONNECT_S) || !robot.reserve()) {
            throw new ConnectFailed(Reason.BUSY, "ARIA has not ended the connection before; try again");
        }
        CompletableFuture<Void> attempt = new CompletableFuture<>();
        connecting = attempt;
        time.runAsync("pioneer aria connect", () -> connect(attempt));
        if (!wait.await(attempt::isDone, CONNECT_S)) {
            throw new ConnectFailed(
                    Reason.NO_ANSWER, "ARIA has not connected to " + address() + " within " + (int) CONNECT_S + " s");
        }
        failIfRefused(attempt);
        listener.identified(robot.locked(aria -> reports.identity()));
        listener.configured(robot.locked(aria -> reports.config()));
        time.runAsync("pioneer aria reports", () -> WaitPolicy.without(() -> pollUntilTheEnd(listener)));
        if (!wait.await(() -> reported || hasEnded(), FIRST_SIP_S)) {
            throw new ConnectFailed(Reason.NO_ANSWER, address() + " answered ARIA, but sends no data within 2 s");
        }
        LinkLost ended = end;
        if (ended != null) {
            throw new BotException(address() + " answered ARIA, but then: " + ended.getMessage(), ended);
        }
        time.runAsync("pioneer aria laser", () -> connectLaser(listener));
    }

    /** The robot can be driven meanwhile. An ARIA without the classes for it has no laser. */
    private void connectLaser(Listener listener) {
        try {
            if (!robot.laser().connect() && !hasEnded()) {
                listener.notice("ARIA cannot reach the robot's laser; see its messages in the terminal");
            }
        } catch (RuntimeException | LinkageError e) {
            LOG.log(Level.DEBUG, "ARIA connects to no laser", e);
        }
    }

    private void connect(CompletableFuture<Void> attempt) {
        try {
            robot.connect(device);
            attempt.complete(null);
        } catch (RuntimeException | Error e) {
            attempt.completeExceptionally(e);
        }
        wait.raise();
    }

    private void failIfRefused(CompletableFuture<Void> attempt) {
        try {
            attempt.join();
        } catch (CompletionException e) {
            throw e.getCause() instanceof BotException refused
                    ? new BotException(String.valueOf(refused.getMessage()), refused)
                    : failedToConnect(e.getCause());
        }
    }

    private BotException failedToConnect(Throwable cause) {
        return new BotException("ARIA failed while connecting to " + address() + ": " + cause, cause);
    }

    /**
     * Reports the end, whichever thread has caused it; any error ends the connection, which nothing would watch after
     * it.
     */
    private void pollUntilTheEnd(Listener listener) {
        try {
            while (!hasEnded()) {
                poll(listener);
                time.sleep(POLL_S);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            abort(new LinkLost("connection lost: interrupted"));
        } catch (LinkLost e) {
            abort(e);
        } catch (RuntimeException | Error e) {
            abort(failed(e));
        }
        listener.ended(Objects.requireNonNull(end));
    }

    private void poll(Listener listener) {
        if (suspend.wasSuspended()) {
            throw asleep();
        }
        News news = robot.locked(aria -> look(aria.isConnected()));
        if (!news.connected) {
            throw new LinkLost("connection lost: ARIA has lost the robot");
        }
        Sip sip = news.sip;
        if (sip != null) {
            deliver(sip, news.others, listener);
            reported = true;
            wait.raise();
        }
        if (reported && !laserFailed) {
            readLaser(listener);
        }
    }

    private void readLaser(Listener listener) {
        try {
            robot.laser().scan(time.nanos(), reports.pose()).ifPresent(scan -> {
                listener.reported(scan);
                wait.raise();
            });
        } catch (RuntimeException | LinkageError e) {
            laserFailed = true;
            listener.notice("ARIA failed to read the robot's laser: " + e);
        }
    }

    /** An error in the driver does not end the reports, as it does not on a line. */
    private static void deliver(Sip sip, List<Report> others, Listener listener) {
        try {
            listener.reported(sip);
            others.forEach(listener::reported);
        } catch (RuntimeException e) {
            LOG.log(Level.WARNING, "could not take in " + sip, e);
        }
    }

    private News look(boolean connected) {
        boolean fresh = connected && reports.hasNewSip(time.nanos());
        return fresh ? new News(true, reports.sip(), reports.others()) : new News(connected, null, List.of());
    }

    @Override
    public void send(Packet... commands) {
        LinkLost ended = end;
        if (ended != null) {
            throw new LinkLost(ended.getMessage(), ended);
        }
        try {
            execute(commands);
        } catch (LinkLost e) {
            abort(e);
            throw e;
        } catch (BotException e) {
            throw e;
        } catch (RuntimeException | Error e) {
            LinkLost cause = failed(e);
            abort(cause);
            throw cause;
        }
        sentNanos = time.nanos();
    }

    private void execute(Packet... commands) {
        if (suspend.wasSuspended()) {
            throw asleep();
        }
        robot.locked(aria -> {
            for (Packet command : commands) {
                LOG.log(Level.TRACE, () -> "> " + command);
                AriaCommands.execute(aria, command);
            }
            return true;
        });
    }

    private static LinkLost failed(Throwable cause) {
        return new LinkLost("connection lost: ARIA failed: " + cause, cause);
    }

    private static LinkLost asleep() {
        return new LinkLost("connection lost: this computer was asleep");
    }

    @Override
    public long sentNanos() {
        return sentNanos;
    }

    @Override
    public boolean isFast() {
        return true;
    }

    /** The library keeps them. */
    @Override
    public boolean passesAnswers() {
        return false;
    }

    @Override
    public boolean carriesScans() {
        return false;
    }

    @Override
    public boolean delivers(ReportKind kind) {
        return kind == ReportKind.PORTS || kind == ReportKind.ENCODERS;
    }

    @Override
    public @Nullable LinkLost end() {
        return end;
    }

    /** Returns at once. ARIA ends the robot's session, which switches its motors off, and then the connection. */
    @Override
    public void abort(LinkLost cause) {
        keep(cause);
        disconnect();
    }

    /** Keeps the first cause. */
    private synchronized void keep(LinkLost cause) {
        end = end == null ? cause : end;
    }

    @Override
    public RobotLine line() {
        return this;
    }

    @Override
    public String address() {
        return device.address();
    }

    @Override
    public boolean scales() {
        return true;
    }

    @Override
    public String missing() {
        return "ARIA does not tell";
    }

    @Override
    public @Nullable PacketCounts counts() {
        return null;
    }

    @Override
    public void close() {
        keep(new LinkLost("connection closed"));
        disconnect();
        wait.waiting().awaitClosing(() -> !robot.isInUse(), DISCONNECT_S);
    }

    /** Disconnects on a thread of its own; an attempt to connect that goes on is awaited before. */
    private void disconnect() {
        CompletableFuture<Void> attempt = connecting;
        if (attempt != null && !disconnecting.getAndSet(true)) {
            time.runAsync("pioneer aria disconnect", () -> {
                wait.waiting().awaitClosing(attempt::isDone, CONNECT_S);
                try {
                    robot.disconnect();
                } catch (RuntimeException | Error e) {
                    LOG.log(Level.WARNING, "ARIA failed to disconnect from " + address(), e);
                }
                wait.raise();
            });
        }
    }
}
