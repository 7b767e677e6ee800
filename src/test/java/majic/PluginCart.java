package majic;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import majic.bot.BotAddress;
import majic.bot.BotEnvironment;
import majic.bot.BotException;
import majic.bot.BotProfile;
import majic.bot.BotState;
import majic.bot.BotType;
import majic.bot.LinkLost;
import majic.bot.MajicBot;
import majic.bot.Motion;
import majic.bot.Pose;
import majic.bot.Range;
import majic.bot.Value;
import majic.link.Link;
import majic.link.Links;

/**
 * The driver of a cart that is known only by its plug-in: the cart accepts lines of text over TCP and drives until it
 * receives a stop.
 */
final class PluginCart extends MajicBot {
    private final Link link;

    PluginCart(String address) {
        super(
                new Type(),
                new BotProfile(200, new Range(-1000, 1000), new Range(-180, 180), 100, 45, 500, true),
                BotEnvironment.plain());
        link = Links.of(BotAddress.parse(address).rest(), 0, 0);
    }

    @Override
    protected void open() {
        try {
            link.open(3000);
        } catch (IOException e) {
            throw new BotException(e.getMessage(), e);
        }
    }

    @Override
    protected void shut() {
        link.close();
    }

    @Override
    protected Value moveBy(double mm, Motion motion) {
        motion.send(() -> driveAt(100, 0));
        motion.pause(mm / 100);
        return null;
    }

    @Override
    protected Value turnBy(double degrees, Motion motion) {
        throw new UnsupportedOperationException();
    }

    @Override
    protected void driveAt(double mmPerSec, double degPerSec) {
        write("go\n");
        publish(new BotState(Pose.START, mmPerSec, degPerSec, true, time().nanos()));
    }

    @Override
    protected void halt() {
        write("halt\n");
    }

    private void write(String line) {
        try {
            link.write(line.getBytes(StandardCharsets.US_ASCII));
        } catch (IOException e) {
            throw new LinkLost(e.getMessage(), e);
        }
    }

    private static final class Type implements BotType {
        @Override
        public String name() {
            return "cart";
        }

        @Override
        public String label() {
            return "Cart";
        }

        @Override
        public String make() {
            return "Test Cart";
        }

        @Override
        public List<Reach> reaches() {
            return List.of(Reach.TCP);
        }

        @Override
        public int defaultPort() {
            return 0;
        }

        @Override
        public MajicBot create(String address, BotEnvironment environment) {
            return new PluginCart("cart:" + address);
        }

        @Override
        public String advice() {
            return "None.";
        }
    }
}
