package majic.figures;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.locks.LockSupport;
import majic.bot.BotAddress;
import majic.bot.FakeType;
import majic.bot.MajicBot;
import majic.environment.BotEnvironment;
import majic.program.Program;
import majic.program.UserFolder;
import majic.server.LineServer;
import majic.server.ListenToken;
import majic.team.TeamListener;

/**
 * How long STOP takes from one program's socket to the team, alone, beside 300 programs that only hold their
 * connections, of which the server admits 64, and beside 300 that send lines as fast as the system takes them and
 * connect again when they are closed.
 */
final class ClientFlood implements AutoCloseable {
    private static final int OTHERS = 300;
    private static final int ROUNDS = 100;
    private static final int SETTLING_MS = 2000;

    /** Between two stops, since the server runs 20 of a program a second. */
    private static final int PAUSE_MS = 60;

    private final Program program;
    private final LineServer server;
    private final byte[] token;
    private final Socket stopper;
    private final BufferedReader answers;
    private final BlockingQueue<Long> stopped = new LinkedBlockingQueue<>();
    private final List<SocketChannel> others = new ArrayList<>();
    private volatile boolean flooding;
    private volatile boolean over;
    private int closed;

    private ClientFlood() throws IOException {
        Path folder = Files.createTempDirectory("majic-flood");
        program = new Program(new UserFolder(folder), null, false);
        MajicBot bot = new FakeType().create(BotAddress.parse("fake:one"), BotEnvironment.plain());
        bot.connect();
        program.team().add(bot, OptionalInt.empty());
        program.team().addListener(new TeamListener() {
            @Override
            public void latchChanged(boolean latched) {
                if (latched) {
                    stopped.offer(System.nanoTime());
                }
            }
        });
        server = program.listen(
                new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), port -> ListenToken.create(folder, port));
        server.ready();
        token = (server.token().orElseThrow().word() + "\n").getBytes(StandardCharsets.UTF_8);
        stopper = new Socket(InetAddress.getLoopbackAddress(), server.port());
        stopper.getOutputStream().write(token);
        answers = new BufferedReader(new InputStreamReader(stopper.getInputStream(), StandardCharsets.UTF_8));
    }

    /** Measures all three cases. */
    static List<String> measure() throws IOException, InterruptedException {
        List<String> lines = new ArrayList<>();
        try (ClientFlood flood = new ClientFlood()) {
            flood.line("warming up");
            lines.add(flood.line("alone"));
            Thread thread = new Thread(flood::keepConnected, "other clients");
            thread.setDaemon(true);
            thread.start();
            Thread.sleep(SETTLING_MS);
            lines.add(flood.line(OTHERS + " idle"));
            flood.flooding = true;
            Thread.sleep(SETTLING_MS);
            lines.add(flood.line(OTHERS + " flooding"));
        }
        return lines;
    }

    private String line(String others) throws IOException, InterruptedException {
        long cpuNanos = serverCpuNanos();
        long beginNanos = System.nanoTime();
        List<Double> ms = new ArrayList<>();
        for (int round = 0; round < ROUNDS; round++) {
            long sentNanos = System.nanoTime();
            send("stop");
            ms.add((stopped.take() - sentNanos) / 1e6);
            await("STOP is latched");
            send("release");
            await("released");
            Thread.sleep(PAUSE_MS);
        }
        double cpu = (serverCpuNanos() - cpuNanos) * 100.0 / (System.nanoTime() - beginNanos);
        Collections.sort(ms);
        return String.format(
                Locale.ROOT,
                "%-12s median %6.2f ms, 19 of 20 within %6.2f ms, longest %6.2f ms; server thread %2.0f %% of a core;"
                        + " %d connections closed so far",
                others,
                ms.get(ROUNDS / 2),
                ms.get(ROUNDS * 19 / 20),
                ms.get(ROUNDS - 1),
                cpu,
                closed);
    }

    private void send(String line) throws IOException {
        stopper.getOutputStream().write((line + "\n").getBytes(StandardCharsets.UTF_8));
    }

    private void await(String part) throws IOException {
        String line = answers.readLine();
        while (line != null && !line.contains(part)) {
            line = answers.readLine();
        }
    }

    private static long serverCpuNanos() {
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        return Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().startsWith("line server"))
                .mapToLong(thread -> threads.getThreadCpuTime(thread.getId()))
                .sum();
    }

    private void keepConnected() {
        ByteBuffer read = ByteBuffer.allocate(1 << 16);
        byte[] lines = "1 get x\n".repeat(1000).getBytes(StandardCharsets.UTF_8);
        while (!over) {
            for (int index = others.size() + (flooding ? 0 : closed); index < OTHERS; index++) {
                connect();
            }
            others.removeIf(client -> isClosed(client, read, lines));
            pauseUnlessFlooding();
        }
    }

    private void pauseUnlessFlooding() {
        if (!flooding) {
            LockSupport.parkNanos(1_000_000L * PAUSE_MS);
        }
    }

    private void connect() {
        try {
            SocketChannel client =
                    SocketChannel.open(new InetSocketAddress(InetAddress.getLoopbackAddress(), server.port()));
            client.write(ByteBuffer.wrap(token));
            client.configureBlocking(false);
            others.add(client);
        } catch (IOException e) {
            closed++;
        }
    }

    private boolean isClosed(SocketChannel client, ByteBuffer read, byte[] lines) {
        try {
            int count = client.read(read.clear());
            if (flooding) {
                client.write(ByteBuffer.wrap(lines));
            }
            if (count >= 0) {
                return false;
            }
            client.close();
        } catch (IOException e) {
            // the server has closed it
        }
        closed++;
        return true;
    }

    @Override
    public void close() throws IOException {
        over = true;
        stopper.close();
        program.close();
    }
}
