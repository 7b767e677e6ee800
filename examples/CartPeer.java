import java.nio.charset.StandardCharsets;
import java.util.Locale;
import majic.bot.BotAddress;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.drivertest.ScriptedPeer;
import majic.drivertest.TestedRobot;
import majic.environment.BotEnvironment;
import majic.environment.Settings;

/**
 * Plays a cart for the tests of its driver: drives as commanded and reports ten times a second its position and the
 * distance of a wall across its way.
 */
final class CartPeer implements TestedRobot, ScriptedPeer.Robot {
    /** Where the wall is, ahead of the start. */
    static final double WALL_MM = 2000;

    private static final int REPORT_MS = 100;
    private static final double SONAR_MM = 180;

    private final ScriptedPeer peer = new ScriptedPeer(this);
    private final MajicBot bot = new Cart.Type()
            .create(
                    BotAddress.parse("cart://" + peer.address()),
                    new BotEnvironment(peer.clock().time(), Settings.inMemory()));
    private final StringBuilder input = new StringBuilder();
    private volatile Pose pose = Pose.START;
    private volatile boolean silent;
    private volatile boolean blocked;
    private double mmPerSec;
    private double degPerSec;

    @Override
    public void received(ScriptedPeer client, byte[] bytes) {
        input.append(new String(bytes, StandardCharsets.US_ASCII));
        for (int end = input.indexOf("\n"); end >= 0; end = input.indexOf("\n")) {
            obey(input.substring(0, end).split(" "));
            input.delete(0, end + 1);
        }
    }

    private void obey(String... words) {
        mmPerSec = Double.parseDouble(words[1]);
        degPerSec = Double.parseDouble(words[2]);
    }

    @Override
    public void step(ScriptedPeer client) {
        if (!blocked) {
            pose = pose.after(mmPerSec / 1000, degPerSec / 1000);
        }
        if (!silent && client.millis() % REPORT_MS == 0) {
            client.send(report().getBytes(StandardCharsets.US_ASCII));
        }
    }

    private String report() {
        return String.format(
                Locale.ROOT,
                "at %.0f %.0f %.1f\nrange %.0f\n",
                pose.xMm(),
                pose.yMm(),
                pose.headingDeg(),
                WALL_MM - SONAR_MM - pose.xMm());
    }

    /** A cart stops when its connection ends, and forgets what has arrived of a line. */
    @Override
    public void left(boolean reset) {
        mmPerSec = 0;
        degPerSec = 0;
        input.setLength(0);
    }

    @Override
    public MajicBot bot() {
        return bot;
    }

    @Override
    public Pose truePose() {
        return pose;
    }

    @Override
    public void cut() {
        peer.hangUp();
        left(false);
    }

    @Override
    public void fallSilent() {
        silent = true;
    }

    /** An obstacle prevents the wheels of a cart from turning. */
    @Override
    public void block() {
        blocked = true;
    }

    @Override
    public void unblock() {
        blocked = false;
    }

    @Override
    public void close() {
        bot.close();
        peer.close();
    }
}
