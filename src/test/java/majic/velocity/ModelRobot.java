package majic.velocity;

import java.util.concurrent.atomic.AtomicReference;
import majic.bot.Pose;
import majic.drivertest.TestClock;
import majic.drivertest.TestedRobot;

/** A modelled base and its driver on a stepped clock. */
final class ModelRobot implements TestedRobot {
    private static final double SILENCE_S = 1;

    private final AtomicReference<BaseModel> stepped = new AtomicReference<>();
    final TestClock clock = new TestClock(this::step, () -> true);
    final BaseModel base;
    final ModelDriver bot;

    ModelRobot(BaseModel.Traits traits) {
        this(traits, VelocityMotion.PoseSource.ODOMETRY);
    }

    ModelRobot(BaseModel.Traits traits, VelocityMotion.PoseSource source) {
        double timeoutS = traits.timeoutMs() == 0 ? Double.POSITIVE_INFINITY : traits.timeoutMs() / 1e3;
        bot = new ModelDriver(clock.time(), timeoutS, source);
        base = new BaseModel(traits, bot::received);
        bot.base = base;
        stepped.set(base);
    }

    private void step(long nanos) {
        BaseModel there = stepped.get();
        if (there != null) {
            there.step();
        }
    }

    /** Connects; returns this. */
    ModelRobot connected() {
        bot.connect();
        return this;
    }

    @Override
    public ModelDriver bot() {
        return bot;
    }

    @Override
    public Pose truePose() {
        return base.truePose();
    }

    @Override
    public void cut() {
        bot.cut();
    }

    @Override
    public void fallSilent() {
        base.silent = true;
        bot.every("silence", SILENCE_S / 4, this::checkSilence);
    }

    private void checkSilence() {
        if (bot.time().secondsSince(bot.state().atNanos()) > 2 * SILENCE_S) {
            bot.cut();
        }
    }

    @Override
    public void block() {
        base.blocked = true;
    }

    @Override
    public void unblock() {
        base.blocked = false;
    }

    @Override
    public void close() {
        bot.close();
        clock.close();
    }
}
