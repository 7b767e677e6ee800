package majic.aibo;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * A peer that answers the few things the driver says, on loopback, in real time. It knows no URBI: it looks for the
 * words of the sheet in what arrives.
 */
final class ScriptedDog implements AutoCloseable {
    private static final Pattern POLL = Pattern.compile("(\\w+): every\\((\\d+)\\) \\{ (.*) \\}");
    private static final Pattern READING = Pattern.compile("(\\w+)(:| <<) ([\\w.]+(?:\\(\\))?)");
    private static final Pattern ENDING = Pattern.compile("(\\w+)(\\+begin)?\\+end: (.*)", Pattern.DOTALL);
    private static final Pattern GAIT = Pattern.compile("robot\\.(?:walk|turn)\\((-?\\d+)\\)");
    private static final Pattern BINARY = Pattern.compile(".*BIN (\\d+) [^;]*;", Pattern.DOTALL);
    private static final Pattern RENEWAL = Pattern.compile("majic\\.\\w+ = (\\d+)");
    private static final Pattern JOINT = Pattern.compile("(\\w+)\\.val = (-?[\\d.]+)(?: time:(\\d+))?");

    private final ServerSocket server;
    private final long startedNanos = System.nanoTime();
    private final ScheduledExecutorService clock = clock();
    private final List<Line> lines = new CopyOnWriteArrayList<>();
    private final Map<String, ScheduledFuture<?>> running = new ConcurrentHashMap<>();
    private final Map<String, String> values = new ConcurrentHashMap<>();
    private final List<String> received = new CopyOnWriteArrayList<>();
    private final List<String> binaries = new CopyOnWriteArrayList<>();
    volatile boolean answersPolls = true;
    volatile boolean introducesItself = true;

    /** What it never answers a question about. */
    volatile String silentAbout = "";

    volatile boolean refusesGuards;

    /** Whether it leaves tags out as 1.5 does: only flags and channels have one. */
    volatile boolean speaks15;

    /** How much later than it was said everything is heard of it. */
    volatile long slownessMs;

    /** How long what is neither a gait nor a joint takes. */
    volatile long lastingMs = 20;

    /** Whether it lies down when it is told to. */
    volatile boolean staysUp;

    /** A word of the commands that it complains of. */
    volatile String knowsNo = "nothing of that kind";

    /** How much later than it came every command is carried out. */
    volatile long heedlessnessMs;

    /** What its guard goes by; for as long as nobody sets it, there is nothing to guard. */
    private volatile double aliveMs = Double.MAX_VALUE;

    /** How often its guard has ended a walk. */
    final AtomicInteger guardEnded = new AtomicInteger();

    /** How many gaits have gone on at the same time. */
    final AtomicInteger mostAtOnce = new AtomicInteger();

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

    /** Gives the connection of an index in each further attempt to connect a trouble. */
    synchronized void trouble(int connection, Trouble trouble) {
        accepted = 0;
        troubles.put(connection, trouble);
    }

    private synchronized Trouble next() {
        return troubles.getOrDefault(accepted++, Trouble.NONE);
    }

    private static ScheduledExecutorService clock() {
        ScheduledThreadPoolExecutor clock = new ScheduledThreadPoolExecutor(1);
        clock.setRemoveOnCancelPolicy(true);
        return clock;
    }

    ScriptedDog() throws IOException {
        server = new ServerSocket(0, 10, InetAddress.getLoopbackAddress());
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

    String address() {
        return "//127.0.0.1:" + server.getLocalPort();
    }

    void set(String expression, String printed) {
        values.put(expression, printed);
    }

    /** Every command so far, in the order of arrival. */
    List<String> received() {
        return List.copyOf(received);
    }

    /** The commands with a word in them; those about the pace of its legs only if it is named. */
    List<String> received(String word) {
        return received.stream()
                .filter(command -> command.contains(word) && !command.contains("every"))
                .filter(command -> word.contains("speed") || !command.contains("speed"))
                .toList();
    }

    /** Waits until a command with a word in it has come; for ever, so tests have a time-out. */
    void awaitReceived(String word) {
        synchronized (received) {
            try {
                while (received(word).isEmpty()) {
                    received.wait();
                }
            } catch (InterruptedException e) {
                throw new IllegalStateException("never came: " + word, e);
            }
        }
    }

    /** Every assignment of a binary, byte for byte, behind the index of its connection and a colon. */
    List<String> binaries() {
        return List.copyOf(binaries);
    }

    private void remember(String command) {
        synchronized (received) {
            received.add(command);
            received.notifyAll();
        }
    }

    boolean hasWalked() {
        return endings.containsKey("walk");
    }

    boolean isWalking() {
        ScheduledFuture<?> walk = running.get("walk");
        return walk != null && !walk.isDone();
    }

    /** Reads nothing more on one of the connections, which come in the order stop, sensors, motion. */
    void stopReading(int connection) {
        lines.get(connection).deaf = true;
    }

    /** Says something unasked on one of the connections. */
    void say(int connection, String tag, String body) {
        lines.get(connection).say(tag, body);
    }

    void hangUp() {
        lines.forEach(Line::close);
    }

    /** Ends one of the newest three connections. */
    void hangUp(int connection) {
        lines.get(lines.size() - 3 + connection).close();
    }

    /** Another program ends the walk. */
    void endWalk() {
        lines.get(0).stop("walk");
    }

    private void acceptAll() {
        try {
            while (true) {
                Line line = new Line(server.accept(), next());
                lines.add(line);
                Thread reader = new Thread(line::serve, "scripted dog's line");
                reader.setDaemon(true);
                reader.start();
            }
        } catch (IOException e) {
            clock.shutdownNow();
        }
    }

    @Override
    public void close() throws IOException {
        server.close();
        hangUp();
        clock.shutdownNow();
    }

    private long now() {
        return 5000 + (System.nanoTime() - startedNanos) / 1_000_000;
    }

    /** One connection. */
    private final class Line {
        private final Socket socket;
        private final Trouble trouble;
        private final CountDownLatch closed = new CountDownLatch(1);
        private volatile boolean deaf;
        private boolean late;

        Line(Socket socket, Trouble trouble) {
            this.socket = socket;
            this.trouble = trouble;
        }

        void serve() {
            try (InputStream in = socket.getInputStream()) {
                introduce();
                StringBuilder pending = new StringBuilder();
                for (int next = in.read(); next >= 0; next = in.read()) {
                    awaitEndIfDeaf();
                    pending.append((char) next);
                    boolean whole = next == '\n';
                    if (next == ';') {
                        takeBinary(pending, in);
                    }
                    if (whole) {
                        split(pending.toString());
                        pending.setLength(0);
                    }
                }
            } catch (IOException e) {
                close();
            }
        }

        private void takeBinary(StringBuilder pending, InputStream in) throws IOException {
            Matcher header = BINARY.matcher(pending);
            if (header.matches()) {
                byte[] bytes = in.readNBytes(Integer.parseInt(header.group(1)));
                binaries.add(lines.indexOf(this) + ":" + pending + new String(bytes, StandardCharsets.ISO_8859_1));
                pending.setLength(0);
            }
        }

        private void introduce() {
            switch (trouble) {
                case HANGS_UP -> close();
                case HALF_A_BANNER -> {
                    write("[00005152:start] *** URBI Ker");
                    close();
                }
                case GARBAGE_FIRST -> write("\u0001\u00ff]] \"[12 BIN 7\n");
                default -> {}
            }
            if (introducesItself && trouble != Trouble.SAYS_NOTHING && !socket.isClosed()) {
                say("start", "*** URBI Kernel version " + (speaks15 ? "1.5" : "1.0") + " rev. 153 ");
                say("ident", "*** ID: U94665654017648");
                say("power", "*** Battery at 87 %");
            }
        }

        private void awaitEndIfDeaf() {
            try {
                if (deaf) {
                    closed.await();
                }
            } catch (InterruptedException e) {
                throw new IllegalStateException("nobody interrupts a scripted dog", e);
            }
        }

        private void split(String text) {
            int depth = 0;
            int from = 0;
            for (int at = 0; at < text.length(); at++) {
                char next = text.charAt(at);
                depth += next == '{' || next == '(' ? 1 : next == '}' || next == ')' ? -1 : 0;
                if (depth == 0 && (next == ';' || next == ',')) {
                    run(text.substring(from, at).strip());
                    from = at + 1;
                }
            }
        }

        private void run(String command) {
            if (trouble == Trouble.HANGS_UP_AT_A_COMMAND) {
                close();
                return;
            }
            remember(command);
            late |= latenessMs > 0 && command.contains("robot.walk(");
            long delayMs = late ? latenessMs : heedlessnessMs;
            if (delayMs > 0) {
                clock.schedule(() -> execute(command), delayMs, TimeUnit.MILLISECONDS);
            } else {
                execute(command);
            }
        }

        private void execute(String command) {
            Matcher poll = POLL.matcher(command);
            Matcher ending = ENDING.matcher(command);
            Matcher renewal = RENEWAL.matcher(command);
            if (command.equals("quit")) {
                close();
            } else if (renewal.matches()) {
                aliveMs = Double.parseDouble(renewal.group(1));
            } else if (command.startsWith("stop ")) {
                stop(command.substring(5));
            } else if (poll.matches() && command.contains("time()")) {
                guard();
            } else if (poll.matches()) {
                repeat(poll.group(1), Long.parseLong(poll.group(2)), () -> tell(poll.group(3)));
            } else if (ending.matches()) {
                perform(ending.group(1), ending.group(2) != null, ending.group(3));
            } else if (command.endsWith(": ping")) {
                say(speaks15 ? "" : command.substring(0, command.indexOf(':')), "*** pong time=" + now());
            } else {
                tell(command);
            }
        }

        private void guard() {
            if (refusesGuards) {
                say("error", "!!! 21.9: syntax error, unexpected every");
            } else {
                repeat("guard", 200, this::lookAtGuard);
            }
        }

        private void lookAtGuard() {
            if (now() - aliveMs > 1500 && isWalking()) {
                guardEnded.incrementAndGet();
                stop("walk");
                stop("turn");
            }
        }

        private void tell(String readings) {
            Matcher reading = READING.matcher(readings);
            while (reading.find() && answersPolls) {
                boolean channel = reading.group(2).equals(" <<");
                String expression = reading.group(3);
                if (expression.equals(silentAbout)) {
                    continue;
                }
                String fallback = expression.equals("time()") ? now() + ".000000" : "0.000000";
                String tag = channel == speaks15 ? reading.group(1) : "";
                say(tag, channel && !speaks15 ? "!!! syntax error" : values.getOrDefault(expression, fallback));
            }
        }

        private void perform(String tag, boolean begin, String command) {
            if (command.contains(knowsNo)) {
                say(tag, "!!! Error with function eval: " + knowsNo + " [no param]");
                return;
            }
            if (begin) {
                say(tag, "*** begin");
            }
            String key = command.contains("walk(") ? "walk" : command.contains("turn(") ? "turn" : tag;
            long others = Stream.of("walk", "turn")
                    .map(running::get)
                    .filter(gait -> gait != null && !gait.isDone())
                    .count();
            running.put(key, clock.schedule(() -> end(tag, command), lasts(command), TimeUnit.MILLISECONDS));
            if (!key.equals(tag)) {
                mostAtOnce.accumulateAndGet((int) others + 1, Math::max);
            }
            endings.put(key, () -> say(tag, "*** end"));
        }

        private void end(String tag, String command) {
            Matcher joint = JOINT.matcher(command);
            if (joint.find()) {
                set(joint.group(1) + ".val", joint.group(2) + ".000000");
            }
            if (command.contains("stand")) {
                set("robot.MyguessPosition()", "\"stand\"");
                set("legLF1.load", "1.000000");
            }
            if (command.contains("robot.lay") && !staysUp) {
                set("robot.MyguessPosition()", "\"lay\"");
            }
            if (command.contains("motors off")) {
                set("legLF1.load", "0.000000");
            }
            say(tag, "*** end");
        }

        private void repeat(String tag, long periodMs, Runnable task) {
            running.put(tag, clock.scheduleAtFixedRate(task, 0, periodMs, TimeUnit.MILLISECONDS));
        }

        private void stop(String tag) {
            ScheduledFuture<?> stopped = running.remove(tag);
            boolean inside = tag.equals("walk") || tag.equals("turn");
            if (stopped != null && stopped.cancel(false) && inside) {
                endings.get(tag).run();
            }
        }

        private void say(String tag, String body) {
            String name = tag.isEmpty() ? "" : ":" + tag;
            String message = String.format("[%08d%s] %s", now(), name, body) + (body.startsWith("BIN ") ? "" : "\n");
            if (slownessMs > 0) {
                clock.schedule(() -> write(message), slownessMs, TimeUnit.MILLISECONDS);
            } else {
                write(message);
            }
        }

        private synchronized void write(String message) {
            try {
                byte[] bytes = message.getBytes(StandardCharsets.ISO_8859_1);
                int piece = trouble == Trouble.SAYS_ALL_IN_SINGLE_BYTES ? 1 : bytes.length;
                for (int at = 0; at < bytes.length; at += piece) {
                    socket.getOutputStream().write(bytes, at, piece);
                }
            } catch (IOException e) {
                close();
            }
        }

        void close() {
            closed.countDown();
            try {
                socket.close();
            } catch (IOException e) {
                throw new IllegalStateException(e);
            }
        }
    }

    private final Map<String, Runnable> endings = new ConcurrentHashMap<>();

    private long lasts(String command) {
        Matcher gait = GAIT.matcher(command);
        Matcher joint = JOINT.matcher(command);
        if (gait.find()) {
            return Math.abs(Long.parseLong(gait.group(1)));
        }
        return joint.find() && joint.group(3) != null ? Long.parseLong(joint.group(3)) : lastingMs;
    }
}
