package majic.driver;

import majic.bot.LinkLost;
import majic.bot.Value;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/** A driver as its gate and its motions use it. */
final class MovingDriver implements MovingRobot {
    private final BotDriver bot;
    private final Readings readings;

    MovingDriver(BotDriver bot, Readings readings) {
        this.bot = bot;
        this.readings = readings;
    }

    @Override
    public String name() {
        return bot.name();
    }

    @Override
    public TimeSource time() {
        return bot.time();
    }

    @Override
    public Signal changes() {
        return bot.changes();
    }

    @Override
    public boolean isConnected() {
        return bot.isConnected();
    }

    @Override
    public void requireConnected() {
        bot.requireConnected();
    }

    @Override
    public long readings() {
        return readings.count();
    }

    @Override
    public void lookAgain() {
        readings.lookAgain();
    }

    @Override
    public void notice(String message) {
        bot.notice(message);
    }

    @Override
    public void lost(LinkLost cause) {
        bot.lost(cause);
    }

    @Override
    public void driveAt(double mmPerSec, double degPerSec) {
        bot.driveAt(mmPerSec, degPerSec);
    }

    @Override
    public @Nullable Value driveFor(double mmPerSec, double degPerSec, double seconds, Motion motion) {
        return bot.driveFor(mmPerSec, degPerSec, seconds, motion);
    }

    @Override
    public void halt() {
        bot.halt();
    }

    @Override
    public void haltAhead() {
        bot.haltAhead();
    }

    @Override
    public void confirmHalt() {
        bot.confirmHalt();
    }

    @Override
    public @Nullable Value driven() {
        return bot.driven();
    }
}
