package majic.hemisson;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Function;
import majic.bot.Agenda;
import majic.drivertest.TestClock;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.link.Loopback;
import majic.time.PeerClock;
import majic.time.TimeSource;
import majicsim.net.LineCount;
import org.jspecify.annotations.Nullable;

/**
 * A peer behind a loopback socket that answers commands by a script, and records what it received and when. Its clock
 * steps, unless a window is to be used with it.
 */
final class ScriptedHemisson implements AutoCloseable {
    private static final long ANSWERS_AFTER_MS = 4;

    /** A command and when it arrived. */
    record Heard(String command, long nanos) {}

    private final ServerSocket server = Loopback.listen();
    private final List<Heard> heard = new CopyOnWriteArrayList<>();
    private final Map<Character, Function<String, String>> answers = new ConcurrentHashMap<>();
    private final @Nullable TestClock clock;
    private final TimeSource time;
    private final Agenda agenda;
    private volatile String arguments = ",0,0";
    private volatile String speeds = "00,00";
    private volatile boolean silent;
    private volatile @Nullable Line line;
    private volatile byte[] greeting = {};

    ScriptedHemisson() {
        this(true);
    }

    /** A peer on the system's clock, which windows use. */
    static ScriptedHemisson inRealTime() {
        return new ScriptedHemisson(false);
    }

    private ScriptedHemisson(boolean stepped) {
        clock = stepped ? PeerClock.between("127.0.0.1:" + server.getLocalPort(), this::lines) : null;
        time = clock == null ? TimeSource.system() : clock.time();
        agenda = new Agenda(time);
        answers.put('B', command -> "b,HemiOS_v_1.50");
        answers.put('I', command -> "i,1,1,1,1");
        answers.put('N', command -> "n,004,004,004,004,004,004,060,080");
        answers.put('O', command -> "o,220,220,220,220,220,220,220,200");
        answers.put('E', command -> "e," + speeds);
        answers.put('H', command -> "h");
        answers.put('J', command -> "j");
        answers.put('T', command -> "t,000");
        answers.put('L', command -> "l");
        answers.put('D', this::setSpeeds);
        Thread thread = new Thread(this::serve, "scripted hemisson");
        thread.setDaemon(true);
        thread.start();
    }

    String address() {
        return "tcp://127.0.0.1:" + server.getLocalPort();
    }

    void answer(char command, Function<String, String> answer) {
        answers.put(command, answer);
    }

    void greetWith(byte... bytes) {
        greeting = bytes;
    }

    void fallSilent(boolean now) {
        silent = now;
    }

    /** The environment of a driver that uses the clock of the peer. */
    BotEnvironment environment() {
        return new BotEnvironment(time, Settings.inMemory());
    }

    TestClock clock() {
        return Objects.requireNonNull(clock);
    }

    void hangUp() throws IOException {
        line().close();
    }

    String hangUpInsteadOfAnswering() {
        try {
            hangUp();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return "";
    }

    void say(String text) throws IOException {
        line().write((text + "\r\n").getBytes(StandardCharsets.ISO_8859_1));
    }

    List<Heard> heard() {
        return heard;
    }

    List<String> commands() {
        return heard.stream().map(Heard::command).toList();
    }

    long count(String command) {
        return commands().stream().filter(command::equals).count();
    }

    String setSpeeds(String command) {
        String[] parts = (command.charAt(0) + arguments).split(",");
        speeds = padded(parts[1]) + "," + padded(parts[2]);
        return "d";
    }

    private static String padded(String digit) {
        return digit.startsWith("-") ? digit : "0" + digit;
    }

    private Line line() {
        return Objects.requireNonNull(line);
    }

    private List<LineCount> lines() {
        return Optional.ofNullable(line).map(Line::count).stream().toList();
    }

    private void serve() {
        while (!server.isClosed()) {
            try (Line accepted = new Line(server.accept())) {
                accepted.write(greeting);
                line = accepted;
                accepted.converse();
            } catch (IOException e) {
                continue;
            }
        }
    }

    /** One connection. */
    private final class Line implements AutoCloseable {
        private final Socket socket;
        private final String peer;
        private final AtomicLong consumed = new AtomicLong();
        private final AtomicLong written = new AtomicLong();
        private volatile boolean open = true;

        Line(Socket socket) throws IOException {
            this.socket = socket;
            this.peer = "127.0.0.1:" + socket.getPort();
            socket.setTcpNoDelay(true);
        }

        LineCount count() {
            return new LineCount(
                    "127.0.0.1:" + socket.getLocalPort(), peer, consumed.get(), written.get(), open, false);
        }

        void write(byte[] bytes) throws IOException {
            written.addAndGet(bytes.length);
            socket.getOutputStream().write(bytes);
        }

        void converse() throws IOException {
            InputStream in = socket.getInputStream();
            StringBuilder command = new StringBuilder();
            for (int next = in.read(); next >= 0; next = in.read()) {
                if (next == '\r') {
                    hear(command.toString());
                    command.setLength(0);
                } else {
                    command.append((char) next);
                }
                consumed.incrementAndGet();
            }
        }

        private void hear(String command) {
            heard.add(new Heard(command, time.nanos()));
            if (!silent) {
                String answer = answerTo(command);
                agenda.after(ANSWERS_AFTER_MS, () -> answer(answer));
            }
        }

        private void answer(String answer) {
            try {
                write((answer + "\r\n").getBytes(StandardCharsets.ISO_8859_1));
            } catch (IOException e) {
                open = false;
            }
        }

        @Override
        public void close() throws IOException {
            open = false;
            socket.close();
        }
    }

    /** Answers a command; arguments that it lacks are those of an earlier command. */
    private String answerTo(String command) {
        arguments = command.length() > 1 ? command.substring(1) : arguments;
        Function<String, String> answer = command.isEmpty() ? null : answers.get(command.charAt(0));
        return answer == null ? "Unknown Command ?!" : answer.apply(command);
    }

    @Override
    public void close() throws IOException {
        server.close();
        if (line != null) {
            line().close();
        }
        agenda.close();
        if (clock != null) {
            clock.close();
        }
    }
}
