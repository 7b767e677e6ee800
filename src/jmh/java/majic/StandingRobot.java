package majic;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * The other end of a benchmark: a robot on loopback that takes any number of clients, each on a daemon thread of its own, and
 * says by a clock what robots say unasked.
 */
public final class StandingRobot implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(StandingRobot.class.getName());

    private final String name;
    private final Conversation conversation;
    private final ServerSocket server;
    private final ScheduledThreadPoolExecutor clock = new ScheduledThreadPoolExecutor(1);

    /** What is said with one client, until it leaves. */
    @FunctionalInterface
    public interface Conversation {
        /**
         * Talks with a client on a thread of its own; its socket is closed afterwards.
         *
         * @param client the client
         * @param robot whom it talks to
         * @throws IOException once it is gone
         */
        void with(Socket client, StandingRobot robot) throws IOException;
    }

    /** Something that is said, which fails once nobody is there any more. */
    @FunctionalInterface
    public interface Report {
        /**
         * Says it.
         *
         * @throws IOException if the client is gone
         */
        void say() throws IOException;
    }

    /**
     * Begins to listen at a free port.
     *
     * @param name for its threads
     * @param conversation what it says
     * @throws IOException if there is no free port
     */
    public StandingRobot(String name, Conversation conversation) throws IOException {
        this.name = name;
        this.conversation = conversation;
        this.server = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
        daemon(name + " listens", this::accept);
    }

    /**
     * Where it listens.
     *
     * @return its TCP port on loopback
     */
    public int port() {
        return server.getLocalPort();
    }

    /**
     * Says something from now on again and again, until its client is gone.
     *
     * @param periodMs how often, ms
     * @param report what
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
