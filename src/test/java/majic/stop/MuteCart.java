package majic.stop;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import majic.bot.BotProfile;
import majic.bot.BotState;
import majic.bot.FakeType;
import majic.bot.Pose;
import majic.bot.Range;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.BotDriver;
import majic.driver.Motion;
import majic.environment.BotEnvironment;
import majic.link.Link;
import majic.link.Links;

/** A robot as a plug-in may bring it: takes lines such as {@code drive 100 0} and answers nothing. */
final class MuteCart extends BotDriver {
    private static final int CONNECT_TIMEOUT_MS = 3000;

    private final Link link;

    /** Creates a driver; {@code address} is what follows the type: {@code //127.0.0.1:4000}. */
    MuteCart(String address) {
        super(
                new FakeType("cart"),
                new BotProfile(200, new Range(-1000, 1000), new Range(-180, 180), 100, 45, 100, true),
                BotEnvironment.plain());
        link = Links.of(address, 0, 0);
    }

    @Override
    protected void open() {
        try {
            link.open(CONNECT_TIMEOUT_MS);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    protected void shut() {
        link.close();
    }

    @Override
    protected Value moveBy(double mm, Motion motion) {
        motion.send(() -> driveAt(Math.signum(mm) * cruiseMmPerSec(), 0));
        motion.pause(Math.abs(mm) / cruiseMmPerSec());
        motion.send(this::halt);
        return Value.about(mm, Unit.MM);
    }

    @Override
    protected Value turnBy(double degrees, Motion motion) {
        throw new UnsupportedOperationException();
    }

    @Override
    protected void driveAt(double mmPerSec, double degPerSec) {
        String line = String.format(Locale.ROOT, "drive %.0f %.0f\n", mmPerSec, degPerSec);
        try {
            link.write(line.getBytes(StandardCharsets.US_ASCII));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        publish(new BotState(Pose.START, mmPerSec, degPerSec, mmPerSec != 0, time().nanos()));
    }

    @Override
    protected void halt() {
        driveAt(0, 0);
    }
}
