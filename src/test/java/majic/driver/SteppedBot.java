package majic.driver;

import majic.bot.FakeBot;
import majic.drivertest.TestClock;

/** A connected {@link FakeBot} on its own stepped clock, for one test. */
final class SteppedBot implements AutoCloseable {
    final TestClock clock = new TestClock();
    final FakeBot bot = FakeBot.on(clock.time());

    SteppedBot() {
        bot.connect();
    }

    @Override
    public void close() {
        bot.close();
        clock.close();
    }
}
