package majic.program;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import majic.act.file.ActCatalog;
import majic.act.file.ActTrust;
import majic.bot.BotException;
import majic.driver.ShutdownHook;
import majic.environment.Settings;
import majic.log.SessionLog;
import majic.nav.Navigator;
import majic.nav.path.Way;
import majic.recorder.Recorder;
import majic.recorder.RecordingFolder;
import majic.script.Session;
import majic.server.LineServer;
import majic.server.ListenKey;
import majic.shared.embedded.EmbeddedBroker;
import majic.shared.embedded.EmbeddedOptions;
import majic.simulation.SimulatedLab;
import majic.team.AutoReconnect;
import majic.team.BotFactory;
import majic.team.Team;
import majic.text.IoReason;
import majic.text.LateLogger;
import majic.time.TimeSource;
import majicsim.LabOptions;
import org.jspecify.annotations.Nullable;

/**
 * One running MAJIC: team, session, and optionally a lab. Closing it stops and closes all robots within 3 s, whatever
 * the state of their connections; this happens at the latest when the program is asked to end.
 */
public final class Program implements AutoCloseable {
    private static final System.Logger LOG = LateLogger.of(Program.class);
    private static final int CLOSE_BOUND_MS = 3000;

    private final UserFolder folder;
    private final BotFactory factory;
    private volatile @Nullable SimulatedLab lab;
    private final UserSettings settings;
    private final List<String> problems = new ArrayList<>();
    private final Team team;
    private final Session session;
    private final SessionLog log;
    private final @Nullable Recorder recorder;
    private final ProgramSharing sharing;
    private volatile @Nullable LineServer server;
    private volatile @Nullable EmbeddedBroker broker;
    private final CountDownLatch quit = new CountDownLatch(1);
    private final AtomicBoolean announced = new AtomicBoolean();
    private final AtomicBoolean closing = new AtomicBoolean();
    private final CountDownLatch closed = new CountDownLatch(1);

    /**
     * Builds everything; starts nothing. The file of the session log is made by {@link #announce}.
     *
     * @param folder the user's folder
     * @param lab a running lab; null for none
     * @param records whether what the robots report is recorded
     */
    public Program(UserFolder folder, @Nullable SimulatedLab lab, boolean records) {
        this(folder, lab, records, Team.MAX_BOTS);
    }

    /**
     * Builds a program for a team of another size.
     *
     * @param folder the user's folder
     * @param lab a running lab; null for none
     * @param records whether what the robots report is recorded
     * @param maxRobots how many robots the team may have, 1 to {@value Team#MOST_BOTS}
     */
    public Program(UserFolder folder, @Nullable SimulatedLab lab, boolean records, int maxRobots) {
        this.folder = folder;
        this.lab = lab;
        TimeSource time = lab == null ? TimeSource.system() : lab.time();
        settings = new UserSettings(folder.file("settings.properties"));
        Plugins plugins = Plugins.in(folder.file("plugins"));
        problems.addAll(plugins.problems());
        factory = new BotFactory(plugins.types(), settings);
        if (lab != null) {
            factory.useLab(lab);
        }
        team = new Team(time, maxRobots);
        log = SessionLog.unopened();
        ActCatalog acts = new ActCatalog(folder.file("acts"), new ActTrust(settings));
        session = new Session(team, factory, log, acts, quit::countDown);
        sharing = new ProgramSharing(team, settings, new SharedMap(session.map()));
        UsedSite.joinAll(team, factory.types(), sharing);
        recorder = records ? record() : null;
        if (lab != null) {
            lab.onTooSlow(session::alarm);
        }
    }

    private void openLog(Path sessions) {
        try {
            log.open(sessions);
        } catch (IOException e) {
            LOG.log(Level.WARNING, "there is no session log", e);
            problems.add("no session log can be written in " + sessions + ": " + IoReason.of(e)
                    + "; MAJIC goes on without one");
        }
    }

    private Recorder record() {
        Navigator navigator = session.map().navigator();
        Recorder started = new Recorder(
                team,
                factory,
                recordings(),
                session::alarm,
                robot -> navigator.way(robot).map(Way::points).orElse(List.of()));
        session.addListener(started);
        started.start();
        return started;
    }

    /** Returns the folder of the recordings of this and earlier sessions. */
    public RecordingFolder recordings() {
        return new RecordingFolder(folder.file("recordings"));
    }

    /** Returns what records this session; empty if it is not recorded. */
    public Optional<Recorder> recorder() {
        return Optional.ofNullable(recorder);
    }

    /**
     * Registers this program to be closed when the Java program ends, for whatever reason, after the robots are closed.
     */
    public void closeWhenProgramEnds() {
        ShutdownHook.afterwards(this::close);
    }

    /**
     * Starts the usual lab in a program that has none, at the pace of the wall clock. May block.
     *
     * @throws BotException if there is one already or it cannot open its ports
     */
    public synchronized void startLab() {
        if (lab != null) {
            throw new BotException("a lab runs already");
        }
        try {
            SimulatedLab started = SimulatedLab.scaled(LabOptions.standard(), 1);
            lab = started;
            factory.useLab(started);
            started.onTooSlow(session::alarm);
        } catch (IOException e) {
            throw new BotException("the lab cannot start: " + e.getMessage(), e);
        }
    }

    public Settings settings() {
        return settings;
    }

    public UserFolder folder() {
        return folder;
    }

    public Session session() {
        return session;
    }

    public Team team() {
        return team;
    }

    public @Nullable SimulatedLab lab() {
        return lab;
    }

    /**
     * Starts to accept lines over a socket; they wait until {@link #addFirst} has ended. At an address that other
     * computers reach, clients have to use TLS.
     *
     * @param address the address to listen at
     * @param token makes the token of a port, which clients send first; null to accept clients of this computer without
     *     one
     * @return the server
     * @throws IllegalArgumentException if clients of other computers would need no token; the message says so
     * @throws IOException if the port is taken, or there is no key for TLS
     */
    public LineServer listen(InetSocketAddress address, LineServer.@Nullable TokenMaker token) throws IOException {
        if (address.isUnresolved()) {
            throw new IllegalArgumentException(address.getHostString() + ": not an address of this computer");
        }
        LineServer opened;
        if (address.getAddress().isLoopbackAddress()) {
            opened = LineServer.open(address, session, token);
        } else if (token == null) {
            throw new IllegalArgumentException(
                    address.getHostString() + ": other computers need a token; --listen-open is only for 127.0.0.1");
        } else {
            opened = LineServer.openTls(address, session, token, ListenKey.in(folder.path()));
        }
        server = opened;
        return opened;
    }

    /** Returns what shares the robots with other desks; nothing is shared until it is started. */
    public ProgramSharing sharing() {
        return sharing;
    }

    /**
     * Starts a broker inside this program, which ends with it. Blocks for some seconds.
     *
     * @param options where it listens, and the user that may connect
     * @throws BotException if it is not installed or the port is taken
     */
    public void startBroker(EmbeddedOptions options) {
        broker = EmbeddedBroker.start(options);
    }

    /**
     * Adds the robots that were requested at the start, and then accepts the clients' lines. Blocks until every robot
     * is added or refused.
     *
     * @param robots the robots
     * @return whether every one was added
     * @throws InterruptedException if the thread is interrupted meanwhile
     */
    public boolean addFirst(FirstRobots robots) throws InterruptedException {
        boolean succeeded = robots.addTo(session);
        LineServer listening = server;
        if (listening != null) {
            listening.ready();
        }
        return succeeded;
    }

    /**
     * Begins the session, now that it has a listener: makes the file of the session log, and reports the errors that
     * occurred before, those of plug-ins included. If the log cannot be written, as in a read-only folder, that is
     * reported, and there is none. A STOP of another desk that was latched before is reported, too. Does nothing when
     * called again; may block.
     */
    public void announce() {
        if (!announced.compareAndSet(false, true)) {
            return;
        }
        openLog(folder.file("sessions"));
        problems.forEach(session::alarm);
        session.reportLatch();
        settings.onTrouble(session::alarm);
    }

    /** Connects robots again whose connection is lost, from now on; the window does so by itself. */
    public void reconnectLost() {
        new AutoReconnect(team, member -> {}).enable(true);
    }

    /** Requests the end of the program. */
    public void quit() {
        quit.countDown();
    }

    public boolean isQuitting() {
        return quit.getCount() == 0;
    }

    /** Waits until the end of the program is requested. */
    public void awaitQuit() throws InterruptedException {
        quit.await();
    }

    /**
     * Closes everything; a second caller waits until the first has finished, because the program must not end before.
     */
    @Override
    public void close() {
        if (closing.compareAndSet(false, true)) {
            closeAll();
            closed.countDown();
        } else {
            awaitClosed();
        }
    }

    private void awaitClosed() {
        try {
            if (!closed.await(CLOSE_BOUND_MS, TimeUnit.MILLISECONDS)) {
                LOG.log(Level.WARNING, "the robots could not be closed in time");
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void closeAll() {
        quit.countDown();
        LineServer listening = server;
        if (listening != null) {
            listening.close();
        }
        Thread unshared = started("ending the sharing", sharing::stop);
        Thread robots = started("closing all robots", this::closeTeam);
        try {
            robots.join(CLOSE_BOUND_MS);
            unshared.join(CLOSE_BOUND_MS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        closeBroker();
        recorder().ifPresent(Recorder::close);
        log.close();
        SimulatedLab running = lab;
        if (running != null) {
            running.close();
        }
    }

    private void closeTeam() {
        team.close();
        UsedSite.leaveAll(factory.types());
    }

    private static Thread started(String name, Runnable task) {
        Thread thread = new Thread(task, name);
        thread.setDaemon(true);
        thread.start();
        return thread;
    }

    private void closeBroker() {
        EmbeddedBroker running = broker;
        if (running != null) {
            running.close();
        }
    }
}
