package majic.ros;

import majic.bot.BotException;
import majic.time.Signal;
import majic.time.TimeSource;
import majic.time.WaitPolicy;

/**
 * Pings the server on one connection, and reports when nothing arrives any more. Has a thread of its own: a ping on a
 * stuck connection takes as long as the write deadline, and must not delay what the robot's timer sends on another one.
 * Thread-safe.
 */
final class ServerWatch implements AutoCloseable {
    /**
     * A connection is given up when nothing has arrived for this time, answers to pings included. With the time that an
     * answer takes, a server that hangs is noticed within a second. Time by which this thread is woken too late does
     * not count: a computer that is so busy does not read what has arrived either.
     */
    static final double SILENCE_S = 0.9;

    /** From one ping to the next. */
    private static final double PING_S = 0.25;

    private final TimeSource time;
    private final Server server;
    private final Runnable onSilence;
    private final Signal ended;
    private volatile boolean over;

    /** The server at the other end of a connection. */
    interface Server {
        /**
         * Asks for a sign of life; may block for the write deadline of the link.
         *
         * @throws BotException if the connection has ended
         */
        void ping();

        /** Returns how long nothing has arrived, s. */
        double silenceS();
    }

    /**
     * Prepares to watch.
     *
     * @param onSilence called at most once, on the watching thread, which must not wait
     */
    ServerWatch(TimeSource time, Server server, Runnable onSilence) {
        this.time = time;
        this.server = server;
        this.onSilence = onSilence;
        this.ended = time.signal();
    }

    /** Begins with a ping; goes on until the silence, the end of the connection or {@link #close}. */
    void start() {
        time.thread("ros watch", () -> WaitPolicy.without(this::run)).start();
    }

    private void run() {
        try {
            watch();
        } catch (BotException e) {
            System.getLogger(ServerWatch.class.getName())
                    .log(System.Logger.Level.DEBUG, "the connection has ended, which its reader thread reports", e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void watch() throws InterruptedException {
        double untilPingS = 0;
        double lateS = 0;
        while (!over) {
            double leftS = SILENCE_S + lateS - server.silenceS();
            if (leftS <= 0) {
                onSilence.run();
                return;
            }
            if (untilPingS <= 0) {
                server.ping();
                untilPingS = PING_S;
            }
            double waitS = Math.min(untilPingS, leftS);
            long fromNanos = time.nanos();
            ended.await(() -> over, waitS);
            double waitedS = time.secondsSince(fromNanos);
            untilPingS -= waitedS;
            lateS = server.silenceS() < waitedS ? 0 : lateS + Math.max(0, waitedS - waitS);
        }
    }

    /** Ends the watch; waits for nothing. */
    @Override
    public void close() {
        over = true;
        ended.raise();
    }
}
