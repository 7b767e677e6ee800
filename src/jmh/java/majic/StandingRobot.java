package majic;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * Simulates a robot on loopback for benchmarks: accepts any number of clients, each on its own daemon thread, and sends
 * periodic reports.
 */
public final class StandingRobot implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(StandingRobot.class.getName());

    private final String name;
    private final Conversation conversation;
    private final ServerSocket server;
    private final ScheduledThreadPoolExecutor clock = new ScheduledThreadPoolExecutor(1);

    /** Handles one client until it disconnects. */
    @FunctionalInterface
    public interface Conversation {
        /**
         * Exchanges data with a client on its own thread; its socket is closed afterwards.
         *
         * @param client the client
         * @param robot the simulated robot
         * @throws IOException once the client has disconnected
         */
        void with(Socket client, StandingRobot robot) throws IOException;
    }

    /** Sends a message; fails once the client has disconnected. */
    @FunctionalInterface
    public interface Report {
        /**
         * Sends the message.
         *
         * @throws IOException if the client has disconnected
         */
        void say() throws IOException;
    }

    /**
     * Starts to listen at a free port.
     *
     * @param name the name of its threads
     * @param conversation handles each client
     * @throws IOException if there is no free port
     */
    public StandingRobot(String name, Conversation conversation) throws IOException {
        this.name = name;
        this.conversation = conversation;
        this.server = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
        daemon(name + " listens", this::accept);
    }

    /**
     * Returns the port at which it listens.
     *
     * @return the TCP port on loopback
     */
    public int port() {
        return server.getLocalPort();
    }

    /**
     * Sends a report periodically from now on, until its client has disconnected.
     *
     * @param periodMs the period, ms
     * @param report sends the report
     */
    public void every(int periodMs, Report report) {
        clock.scheduleAtFixedRate(() -> say(report), 0, periodMs, TimeUnit.MILLISECONDS);
    }

    private static void say(Report report) {
        try {
            report.say();
        } catch (IOException e) {
            throw new IllegalStateException("no more reports to a client that left", e);
        }
    }

    private void accept() {
        try {
            while (true) {
                Socket client = server.accept();
                client.setTcpNoDelay(true);
                daemon(name + " hears " + client.getPort(), () -> serve(client));
            }
        } catch (IOException e) {
            clock.shutdownNow();
        }
    }

    private void serve(Socket client) {
        try (client) {
            conversation.with(client, this);
        } catch (IOException e) {
            LOG.log(System.Logger.Level.DEBUG, "a client left", e);
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
