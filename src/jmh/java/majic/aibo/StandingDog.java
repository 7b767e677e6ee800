package majic.aibo;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * The other end of a benchmark: a dog on loopback that introduces itself, answers every tagged command with the same
 * number, and every standing order with one reading a second. Takes any number of clients.
 */
final class StandingDog implements AutoCloseable {
    static final String INTRODUCTION = """
            [00005152:start] *** URBI Kernel version 1.0 rev. 153
            [00005152:ident] *** ID: U94665654017648
            """;

    private final ServerSocket server;
    private final ScheduledThreadPoolExecutor clock = new ScheduledThreadPoolExecutor(1);

    StandingDog() throws IOException {
        server = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
        daemon("dog listens", this::accept);
    }

    int port() {
        return server.getLocalPort();
    }

    private void accept() {
        try {
            while (true) {
                Socket client = server.accept();
                client.setTcpNoDelay(true);
                daemon("dog hears " + client.getPort(), () -> serve(client));
            }
        } catch (IOException e) {
            clock.shutdownNow();
        }
    }

    private void serve(Socket client) {
        try (client) {
            BufferedReader in =
                    new BufferedReader(new InputStreamReader(client.getInputStream(), StandardCharsets.ISO_8859_1));
            write(client, INTRODUCTION);
            for (String line = in.readLine(); line != null; line = in.readLine()) {
                answer(client, line);
            }
        } catch (IOException e) {
            System.getLogger(StandingDog.class.getName()).log(System.Logger.Level.DEBUG, "client left", e);
        }
    }

    private void answer(Socket client, String line) throws IOException {
        int colon = line.indexOf(':');
        int reading = line.indexOf("{ ") + 2;
        if (line.contains("stop walk")) {
            return;
        }
        if (line.contains("every")) {
            String tag = line.substring(reading, line.indexOf(':', reading));
            clock.scheduleAtFixedRate(() -> report(client, tag), 0, 1, TimeUnit.SECONDS);
        } else if (line.contains("ping")) {
            write(client, "[00005917:" + line.substring(0, colon) + "] *** pong time=5918\n");
        } else if (colon > 0) {
            write(client, "[00005917:" + line.substring(0, colon) + "] 15.000000\n");
        }
    }

    private static void report(Socket client, String tag) {
        try {
            write(client, "[00005917:" + tag + "] 15.000000\n");
        } catch (IOException e) {
            throw new IllegalStateException("no more reports to a client that left", e);
        }
    }

    private static void write(Socket client, String message) throws IOException {
        synchronized (client) {
            client.getOutputStream().write(message.getBytes(StandardCharsets.ISO_8859_1));
        }
    }

    private static void daemon(String name, Runnable body) {
        Thread thread = new Thread(body, name);
        thread.setDaemon(true);
        thread.start();
    }

    @Override
    public void close() throws IOException {
        clock.shutdownNow();
        server.close();
    }
}
