package majic.aibo;

import java.io.IOException;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import majic.driver.RobotWait;
import majic.drivertest.TestClock;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.link.Loopback;
import majic.time.PeerClock;
import majic.time.Signal;
import majic.time.TimeSource;
import majicsim.net.LineCount;
import org.jspecify.annotations.Nullable;

/**
 * A peer on loopback that answers the commands of the driver. It does not parse URBI: it searches for the words of the
 * sheet in what arrives. Its clock steps, unless a test has threads that do not use it. This class has the settings and
 * records of a test; {@link ScriptedLine} is a connection, {@link ScriptedCommands} what comes of a command,
 * {@link ScriptedErrands} what then goes on.
 */
public final class ScriptedDog implements AutoCloseable {
    private final ServerSocket server = Loopback.listen();
    private final @Nullable TestClock clock;
    private final TimeSource time;
    private final Signal news;
    private final ScriptedErrands errands;
    private final long startedNanos;
    private final List<ScriptedLine> lines = new CopyOnWriteArrayList<>();
    private final Map<String, String> values = new ConcurrentHashMap<>();
    private final List<String> received = new CopyOnWriteArrayList<>();
    private final List<String> binaries = new CopyOnWriteArrayList<>();
    volatile boolean answersPolls = true;
    volatile boolean introducesItself = true;

    /** What it never answers a question about. */
    volatile String silentAbout = "";

    volatile boolean refusesGuards;

    /** Whether it reports the begin of a command that is to report it. */
    volatile boolean reportsBegin = true;

    /** Whether it leaves tags out as 1.5 does: only flags and channels have one. */
    volatile boolean speaks15;

    /** The delay of all its messages. */
    volatile long slownessMs = 1;

    /** How long what is neither a gait nor a joint takes. */
    volatile long lastingMs = 20;

    /** Whether it obeys the command to lie down. */
    volatile boolean staysUp;

    /** The posture that it reports when it lies; a real dog with its fore legs at -20 degrees reports "unknown". */
    volatile String guessOnceDown = "lay";

    /** A word of the commands that it complains of. */
    volatile String knowsNo = "nothing of that kind";

    /** How much later than it came every command is carried out. */
    volatile long heedlessnessMs;

    /** What its guard goes by; until it is set, there is nothing to guard. */
    volatile double aliveMs = Double.MAX_VALUE;

    /** How often its guard has ended a walk. */
    public final AtomicInteger guardEnded = new AtomicInteger();

    /** How much later than others a connection delivers, from the first walk on it. */
    volatile long latenessMs;

    /** What is wrong with one of its connections. */
    enum Trouble {
        NONE,
        HANGS_UP,
        SAYS_NOTHING,
        HALF_A_BANNER,
        HANGS_UP_AT_A_COMMAND,
        GARBAGE_FIRST,
        SAYS_ALL_IN_SINGLE_BYTES
    }

    private final Map<Integer, Trouble> troubles = new ConcurrentHashMap<>();
    private int accepted;

    public ScriptedDog() {
        this(true);
    }

    /** One that lives by the system's clock, as windows and stuck threads do. */
    public static ScriptedDog inRealTime() {
        return new ScriptedDog(false);
    }

    private ScriptedDog(boolean stepped) {
        clock = stepped ? PeerClock.between("127.0.0.1:" + server.getLocalPort(), this::counts) : null;
        time = clock == null ? TimeSource.system() : clock.time();
        news = time.signal();
        errands = new ScriptedErrands(time);
        startedNanos = time.nanos();
        set("distanceNear.val", "50.000000");
        set("distance.val", "150.000000");
        set("distanceChest.val", "90.000000");
        set("power()", "0.870000");
        set("robot.MyguessPosition()", "\"lay\"");
        set("system.name", "\"ERS-7\"");
        Thread acceptor = new Thread(this::acceptAll, "scripted dog");
        acceptor.setDaemon(true);
        acceptor.start();
    }

    private void acceptAll() {
        try {
            while (true) {
                ScriptedLine line = new ScriptedLine(this, server.accept(), next());
                line.introduce();
                lines.add(line);
                Thread reader = new Thread(line::serve, "scripted dog's line");
                reader.setDaemon(true);
                reader.start();
            }
        } catch (IOException e) {
            errands.close();
        }
    }

    private synchronized Trouble next() {
        return troubles.getOrDefault(accepted++, Trouble.NONE);
    }

    /** Gives the connection of an index in each further attempt to connect a trouble. */
    synchronized void trouble(int connection, Trouble trouble) {
        accepted = 0;
        troubles.put(connection, trouble);
    }

    public String address() {
        return "//127.0.0.1:" + server.getLocalPort();
    }

    /** What a driver needs to live by its clock. */
    BotEnvironment environment() {
        return environment(Settings.inMemory());
    }

    BotEnvironment environment(Settings settings) {
        return new BotEnvironment(time, settings);
    }

    /** Where a part of a driver waits that lives by its clock. */
    public RobotWait waiting() {
        return new RobotWait(time, time.signal());
    }

    public TestClock clock() {
        return Objects.requireNonNull(clock);
    }

    private List<LineCount> counts() {
        return lines.stream().map(ScriptedLine::count).toList();
    }

    void set(String expression, String printed) {
        values.put(expression, printed);
    }

    /** How an expression prints. */
    String value(String expression) {
        String fallback = expression.equals("time()") ? nowMs() + ".000000" : "0.000000";
        return values.getOrDefault(expression, fallback);
    }

    /** Every command so far, in the order of arrival. */
    public List<String> received() {
        return List.copyOf(received);
    }

    /** The commands that contain a word; those for the pace of its legs only if the word names it. */
    public List<String> received(String word) {
        return received.stream()
                .filter(command -> command.contains(word) && !command.contains("every"))
                .filter(command -> word.contains("speed") || !command.contains("speed"))
                .toList();
    }

    /** Waits until a command with a word in it has come; for ever, so tests have a time-out. */
    public void awaitReceived(String word) {
        try {
            news.await(() -> !received(word).isEmpty(), Signal.FOR_EVER);
        } catch (InterruptedException e) {
            throw new IllegalStateException("never came: " + word, e);
        }
    }

    void remember(String command) {
        received.add(command);
        news.raise();
    }

    /** Every assignment of a binary, byte for byte, behind the index of its connection and a colon. */
    List<String> binaries() {
        return List.copyOf(binaries);
    }

    void rememberBinary(ScriptedLine from, String header, byte[] bytes) {
        binaries.add(lines.indexOf(from) + ":" + header + new String(bytes, StandardCharsets.ISO_8859_1));
    }

    ScriptedErrands errands() {
        return errands;
    }

    /** How many gaits have gone on at the same time. */
    int mostAtOnce() {
        return errands.mostAtOnce();
    }

    boolean hasWalked() {
        return errands.hasBegun("walk");
    }

    public boolean isWalking() {
        return errands.isUnderWay("walk");
    }

    /** Another program ends the walk. */
    void endWalk() {
        errands.stop("walk");
    }

    /** Reads nothing more on one of the connections, which come in the order stop, sensors, motion. */
    public void stopReading(int connection) {
        lines.get(connection).stopReading();
    }

    /** Sends an unrequested message on one of the connections. */
    void say(int connection, String tag, String body) {
        lines.get(connection).say(tag, body);
    }

    void hangUp() {
        lines.forEach(ScriptedLine::close);
    }

    /** Ends one of the newest three connections. */
    void hangUp(int connection) {
        lines.get(lines.size() - 3 + connection).close();
    }

    /** What its clock shows. */
    long nowMs() {
        return 5000 + (time.nanos() - startedNanos) / 1_000_000;
    }

    @Override
    public void close() throws IOException {
        server.close();
        hangUp();
        errands.close();
        if (clock != null) {
            clock.close();
        }
    }
}
