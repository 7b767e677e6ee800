package majic.bot;

import java.util.concurrent.atomic.AtomicLong;

/** Makes the news of one robot wake a motion of another whose guard reads it. */
record ReadingsRelay(Signal changes, AtomicLong readings) implements BotListener {
    @Override
    public void stateChanged(MajicBot bot, BotState state) {
        readings.incrementAndGet();
        changes.raise();
    }

    @Override
    public void connectionChanged(MajicBot bot, MajicBot.Connection connection) {
        readings.incrementAndGet();
        changes.raise();
    }
}
