package majic.figures;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import majic.bot.BotListener;
import majic.bot.MajicBot;
import majic.console.Console;
import majic.log.Line;
import majic.program.FirstRobots;
import majic.program.Program;
import majic.program.UserFolder;
import majic.program.Window;
import majic.script.MajicParser;
import majic.server.LineServer;
import majic.stop.RecordingRelay;
import majic.team.Gate;
import majic.team.Member;
import majic.team.Team;
import majic.team.TeamListener;

/**
 * How long STOP takes, by the key, the console and a socket, to the arrival of its bytes at ten robots that move, and
 * until ten further ones, which never read, are named. Meanwhile five listeners block and an act is read from a pipe.
 */
final class StopTimes {
    private static final int ROUNDS = 50;
    private static final int STUCK = 10;
    private static final int FIRST_STUCK = 11;
    private static final int SETTLING_MS = 300;

    /**
     * What the buffers of the stuck robots take to fill: copying it would delay the stop on a computer with two cores.
     */
    private static final int FILLING_MS = 300;

    private static final int MOST_MS = 8000;
    private static final Map<String, List<String>> STOPS = Map.of(
            "pioneer", List.of("\u00FA\u00FB\u0003\u001D\0\u001D"),
            "aibo", List.of("stop walk, stop turn,"),
            "hemisson", List.of("D,0,0\r", "D\r"));

    private final Program program;
    private final Team team;
    private final List<Healthy> healthy = new ArrayList<>();
    private final Gate gate = new Gate();
    private final Path pipe;
    private final LinkedBlockingQueue<String> typed = new LinkedBlockingQueue<>();
    private final Map<Integer, Long> namedNanos = new ConcurrentHashMap<>();
    private final Socket client;
    private final KeyProgram keys;

    /** A robot that reads: its line, and the forms of its stop. */
    private record Healthy(RecordingRelay line, List<String> stops) {
        /** Returns when the first stop arrived that was sent after the first bytes of the line. */
        OptionalLong arrival(int before) {
            return stops.stream()
                    .map(stop -> line.sent().nanosOf(stop, before))
                    .flatMapToLong(OptionalLong::stream)
                    .min();
        }
    }

    /** A way to stop. */
    private interface Stopping {
        void stop() throws IOException;
    }

    private StopTimes(Path folder) throws IOException, InterruptedException {
        program = new Program(new UserFolder(folder), null, true);
        team = program.team();
        pipe = folder.resolve("pipe.act");
        if (new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor() != 0) {
            throw new IOException("no pipe can be made in " + folder);
        }
        LineServer server = program.listen(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), null);
        server.ready();
        client = new Socket(InetAddress.getLoopbackAddress(), server.port());
        keys = KeyProgram.start();
    }

    /**
     * Measures all three ways.
     *
     * @param addresses the robots that read, with their types, such as {@code pioneer://127.0.0.1:8101}
     */
    static List<String> measure(List<String> addresses) throws Exception {
        KeyArrivals arrivals = KeyArrivals.watch();
        StopTimes times = new StopTimes(Files.createTempDirectory("majic-stop"));
        times.start(addresses);
        List<String> lines = new ArrayList<>();
        lines.add(times.line("F12", () -> {
            arrivals.begin();
            times.keys.press();
        }));
        times.keys.close();
        lines.add(keyLine(arrivals.delaysMs()));
        lines.add(times.line("console", () -> times.typed.add("stop")));
        lines.add(times.line("socket", () -> times.send("stop")));
        return lines;
    }

    private void start(List<String> addresses) throws Exception {
        for (String address : addresses) {
            String[] parts = address.split("://", 2);
            RecordingRelay line = RecordingRelay.tcp(Integer.parseInt(parts[1].replaceFirst(".*:", "")));
            healthy.add(new Healthy(line, STOPS.get(parts[0])));
            add(program.session().factory().create(parts[0] + ":" + line.address()), OptionalInt.empty());
        }
        program.session().addListener(this::note);
        program.session().addListener(line -> gate.pass());
        for (int count = 0; count < 2; count++) {
            team.addListener(gate.blocked(TeamListener.class));
            team.member(count + 1).bot().addListener(gate.blocked(BotListener.class));
        }
        background(() -> new Console(program, new Typed(typed)).run(FirstRobots.NONE, List.of()));
        background(() -> new Window(program).run(started -> FirstRobots.NONE));
        background(() -> client.getInputStream().transferTo(OutputStream.nullOutputStream()));
        send("bots");
        MeasuredWindow.awaitWindow();
        Thread.sleep(MOST_MS);
    }

    private Member add(MajicBot bot, OptionalInt number) {
        if (!bot.isConnected()) {
            bot.connect();
        }
        return team.add(bot, number);
    }

    private void send(String line) throws IOException {
        client.getOutputStream().write((line + "\n").getBytes(StandardCharsets.UTF_8));
    }

    /** Keeps the time of the first line about each robot that has not stopped. */
    private void note(Line line) {
        if (line.kind() == Line.Kind.ALARM) {
            for (int robot = FIRST_STUCK; robot < FIRST_STUCK + STUCK; robot++) {
                if (line.text().matches(".*\\b" + robot + "\\b.*")) {
                    namedNanos.putIfAbsent(robot, System.nanoTime());
                }
            }
        }
    }

    private String line(String way, Stopping stopping) throws Exception {
        List<Double> first = new ArrayList<>();
        List<Double> written = new ArrayList<>();
        List<Double> named = new ArrayList<>();
        measure(stopping, first, new ArrayList<>());
        for (int round = 0; round < ROUNDS; round++) {
            measure(stopping, written, named);
        }
        Collections.sort(written);
        Collections.sort(named);
        return String.format(
                Locale.ROOT,
                "%-8s bytes at a robot: median %5.1f ms, 99 of 100 within %5.1f ms, longest %5.1f ms, %d of %d"
                        + " (the first time: %5.1f ms); stuck robots named: median %4.0f ms, longest %4.0f ms, %d of %d",
                way,
                written.get(written.size() / 2),
                written.get(written.size() * 99 / 100),
                written.get(written.size() - 1),
                written.size(),
                ROUNDS * healthy.size(),
                first.stream().max(Double::compare).orElse(Double.NaN),
                named.isEmpty() ? Double.NaN : named.get(named.size() / 2),
                named.isEmpty() ? Double.NaN : named.get(named.size() - 1),
                named.size(),
                ROUNDS * STUCK);
    }

    /** The first key is left out, as everywhere. */
    private static String keyLine(List<Double> delaysMs) {
        List<Double> sorted = delaysMs.stream().skip(1).sorted().toList();
        return String.format(
                Locale.ROOT,
                "%-8s the event dispatch thread has the key: median %.1f ms, longest %.1f ms",
                "",
                sorted.get(sorted.size() / 2),
                sorted.get(sorted.size() - 1));
    }

    private void measure(Stopping stopping, List<Double> written, List<Double> named) throws Exception {
        List<StuckBot> stuck = addStuck();
        moveHealthy();
        typed.add("1 act " + pipe);
        send("1 act " + pipe);
        gate.close();
        for (StuckBot bot : stuck.subList(0, STUCK / 2)) {
            bot.flood();
        }
        Thread.sleep(FILLING_MS);
        List<Integer> before =
                healthy.stream().map(robot -> robot.line().sent().length()).toList();
        namedNanos.clear();
        long beginNanos = System.nanoTime();
        stopping.stop();
        await(() -> namedNanos.size() == STUCK && arrivals(before).stream().allMatch(OptionalLong::isPresent));
        arrivals(before).forEach(nanos -> nanos.ifPresent(at -> written.add((at - beginNanos) / 1e6)));
        namedNanos.values().forEach(nanos -> named.add((nanos - beginNanos) / 1e6));
        end(stuck);
    }

    /** Returns when the stops arrived that were sent after the first bytes of each line. */
    private List<OptionalLong> arrivals(List<Integer> before) {
        return IntStream.range(0, healthy.size())
                .mapToObj(robot -> healthy.get(robot).arrival(before.get(robot)))
                .toList();
    }

    /** Waits for those that were lost on a busy computer, which the window connects again. */
    private void moveHealthy() throws InterruptedException {
        MajicParser parser = MajicParser.prompt(program.session());
        List<MajicBot> bots = team.members().subList(0, healthy.size()).stream()
                .map(Member::bot)
                .toList();
        for (int robot = 1; robot <= bots.size(); robot++) {
            if (!bots.get(robot - 1).isConnected()) {
                System.out.println(
                        "  robot " + robot + " was lost: " + bots.get(robot - 1).lostReason());
                MajicBot lost = bots.get(robot - 1);
                await(lost::isConnected);
            }
            parser.parseText(robot + " turn 3600");
        }
        await(() -> bots.stream().allMatch(bot -> bot.state().moving()));
        Thread.sleep(SETTLING_MS);
    }

    private static void await(BooleanSupplier condition) throws InterruptedException {
        long beginNanos = System.nanoTime();
        while (!condition.getAsBoolean() && (System.nanoTime() - beginNanos) / 1e6 < MOST_MS) {
            Thread.sleep(1);
        }
    }

    private List<StuckBot> addStuck() throws IOException {
        List<StuckBot> stuck = new ArrayList<>();
        for (int count = 0; count < STUCK; count++) {
            StuckBot bot = StuckBot.connected();
            stuck.add(bot);
            add(bot, OptionalInt.of(FIRST_STUCK + count));
        }
        return stuck;
    }

    private void end(List<StuckBot> stuck) throws Exception {
        gate.open();
        List<Thread> removing = new ArrayList<>();
        for (int count = 0; count < stuck.size(); count++) {
            int number = FIRST_STUCK + count;
            removing.add(background(() -> team.remove(number)));
        }
        for (Thread thread : removing) {
            thread.join();
        }
        await(() -> team.areStopsAnswered() && team.members().stream().noneMatch(Member::isStopping));
        team.release();
    }

    private interface Work {
        void run() throws Exception;
    }

    private static Thread background(Work work) {
        Thread thread = new Thread(() -> {
            try {
                work.run();
            } catch (Exception e) {
                throw new IllegalStateException(e);
            }
        });
        thread.setDaemon(true);
        thread.start();
        return thread;
    }

    /** Lines for a console. */
    private record Typed(LinkedBlockingQueue<String> lines) implements Console.Source {
        @Override
        public String next() {
            try {
                return lines.take();
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
        }

        @Override
        public void show(String line) {
            // not displayed
        }

        @Override
        public boolean interactive() {
            return true;
        }

        @Override
        public void close() {
            // nothing is open
        }
    }
}
