package majic.figures;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.concurrent.CountDownLatch;
import majic.bot.BotException;
import majic.bot.BotProfile;
import majic.bot.FakeType;
import majic.bot.Range;
import majic.bot.Value;
import majic.driver.BotDriver;
import majic.driver.Motion;
import majic.environment.BotEnvironment;
import majic.link.Link;
import majic.link.Links;

/**
 * A robot that accepts a connection and never reads from it, so that it confirms no stop. Owns both ends of the line.
 */
final class StuckBot extends BotDriver {
    private static final int CONNECT_TIMEOUT_MS = 3000;
    private static final double CONFIRM_S = 4;

    /** More than the buffers of both ends take. */
    private static final byte[] FLOOD = new byte[1 << 25];

    private final ServerSocket robot;
    private final Link link;
    private final CountDownLatch flooding = new CountDownLatch(1);
    private volatile Socket end = new Socket();

    private StuckBot(ServerSocket robot) {
        super(
                new FakeType("stuck"),
                new BotProfile(200, new Range(-1000, 1000), new Range(-180, 180), 100, 45, 100, true),
                BotEnvironment.plain());
        this.robot = robot;
        this.link = Links.of("//127.0.0.1:" + robot.getLocalPort(), 0, 0);
    }

    /** Returns a robot that is connected. */
    static StuckBot connected() throws IOException {
        StuckBot bot = new StuckBot(new ServerSocket(0, 1, InetAddress.getLoopbackAddress()));
        bot.connect();
        return bot;
    }

    /**
     * Fills the buffers, as a motion in progress: the write ends only with its time limit. Returns when it has begun.
     */
    StuckBot flood() throws InterruptedException {
        Thread writing = new Thread(() -> move(1000), "flooding " + link.address());
        writing.setDaemon(true);
        writing.setUncaughtExceptionHandler((thread, thrown) -> flooding.countDown());
        writing.start();
        flooding.await();
        return this;
    }

    @Override
    protected void open() {
        try {
            link.open(CONNECT_TIMEOUT_MS);
            end = robot.accept();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    protected void shut() {
        link.abort();
        try {
            end.close();
            robot.close();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    protected Value moveBy(double mm, Motion motion) {
        motion.send(() -> {
            flooding.countDown();
            write(FLOOD);
        });
        throw new BotException("the robot reads again");
    }

    @Override
    protected Value turnBy(double degrees, Motion motion) {
        throw new UnsupportedOperationException();
    }

    @Override
    protected void driveAt(double mmPerSec, double degPerSec) {
        String line = String.format(Locale.ROOT, "drive %.0f %.0f\n", mmPerSec, degPerSec);
        write(line.getBytes(StandardCharsets.US_ASCII));
    }

    @Override
    protected void halt() {
        driveAt(0, 0);
    }

    private void write(byte[] bytes) {
        try {
            link.write(bytes);
        } catch (IOException e) {
            throw new BotException(String.valueOf(e.getMessage()), e);
        }
    }

    @Override
    public void confirmHalt() {
        waiting().await(() -> !isConnected(), CONFIRM_S);
        throw new BotException("the robot has not answered the stop within " + (int) CONFIRM_S + " s");
    }
}
