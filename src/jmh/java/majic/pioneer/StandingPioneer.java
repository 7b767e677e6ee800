package majic.pioneer;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import majic.pioneer.arcos.Bytes;

/**
 * The other end of a benchmark: a robot on loopback that answers the handshake, says every 100 ms that it stands with its
 * motors on, and reads whatever else comes without looking at it. Takes any number of clients.
 */
final class StandingPioneer implements AutoCloseable {
    private static final int SYNC2 = 2;

    private final ServerSocket server;
    private final ScheduledThreadPoolExecutor clock = new ScheduledThreadPoolExecutor(1);

    StandingPioneer() throws IOException {
        server = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
        daemon("pioneer listens", this::accept);
    }

    int port() {
        return server.getLocalPort();
    }

    private void accept() {
        try {
            while (true) {
                Socket client = server.accept();
                client.setTcpNoDelay(true);
                daemon("pioneer hears " + client.getPort(), () -> serve(client));
            }
        } catch (IOException e) {
            clock.shutdownNow();
        }
    }

    private void serve(Socket client) {
        try (client) {
            if (shakesHands(client)) {
                clock.scheduleAtFixedRate(() -> report(client), 0, 100, TimeUnit.MILLISECONDS);
            }
            discard(client.getInputStream());
        } catch (IOException e) {
            System.getLogger(StandingPioneer.class.getName()).log(System.Logger.Level.DEBUG, "client left", e);
        }
    }

    /** Echoes the SYNCs; false for a client that says something else, which is only to be read. */
    private static boolean shakesHands(Socket client) throws IOException {
        byte[] sync = client.getInputStream().readNBytes(6);
        while (sync.length == 6 && sync[3] < SYNC2 && sync[2] == 3) {
            client.getOutputStream().write(sync);
            sync = client.getInputStream().readNBytes(6);
        }
        boolean last = sync.length == 6 && sync[2] == 3;
        if (last) {
            client.getOutputStream().write(Bytes.of(Bytes.NAMES));
        }
        return last;
    }

    private static void report(Socket client) {
        try {
            client.getOutputStream().write(Bytes.of(Bytes.AT_REST));
        } catch (IOException e) {
            throw new IllegalStateException("no more reports to a client that left", e);
        }
    }

    private static void discard(InputStream in) throws IOException {
        byte[] buffer = new byte[8192];
        while (in.read(buffer) >= 0) {
            // Only the reading counts.
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
