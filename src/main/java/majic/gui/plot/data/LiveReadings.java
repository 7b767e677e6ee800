package majic.gui.plot.data;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.LongToDoubleFunction;
import majic.bot.BotException;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.bot.Value;
import majic.team.Member;
import majic.time.WaitPolicy;

/**
 * Reads parameters of one robot whenever it reports something. A parameter that the robot reports only when it is asked
 * is asked for once a second. Listens to the robot while at least one feed is open. Thread-safe.
 */
final class LiveReadings implements BotListener {
    private static final double ASKING_PERIOD_S = 1;

    private final MajicBot bot;
    private final LongToDoubleFunction seconds;
    private final List<Series> series = new CopyOnWriteArrayList<>();
    private boolean asking;

    /** The samples of one curve. Compared by identity: two plots may show the same quantity. */
    private static final class Series {
        private final Quantity quantity;
        private final Samples samples;
        private volatile boolean unknown;

        Series(Quantity quantity, Samples samples) {
            this.quantity = quantity;
            this.samples = samples;
        }
    }

    /**
     * Creates readings without feeds.
     *
     * @param seconds converts a time of the robot's clock, in nanoseconds, to that of the plots
     */
    LiveReadings(Member member, LongToDoubleFunction seconds) {
        this.bot = member.bot();
        this.seconds = seconds;
    }

    /** Adds a reading now, and one at each report of the robot until the feed is closed. */
    PlotSource.Feed feed(Quantity quantity, Samples samples) {
        Series added = new Series(quantity, samples);
        synchronized (this) {
            if (series.isEmpty()) {
                bot.addListener(this);
            }
            series.add(added);
        }
        sample(bot.time().nanos(), List.of(added));
        return () -> remove(added);
    }

    private synchronized void remove(Series closed) {
        if (series.remove(closed) && series.isEmpty()) {
            bot.removeListener(this);
        }
    }

    @Override
    public void stateChanged(MajicBot source, BotState state) {
        sample(state.atNanos(), series);
    }

    /** Interrupts the curves while the connection is lost. */
    @Override
    public void connectionChanged(MajicBot source, MajicBot.Connection connection) {
        if (connection != MajicBot.Connection.CONNECTED) {
            double now = seconds.applyAsDouble(bot.time().nanos());
            series.forEach(each -> each.samples.add(now, Double.NaN));
        }
    }

    private void sample(long atNanos, List<Series> which) {
        double time = seconds.applyAsDouble(atNanos);
        Map<String, Value> values = new HashMap<>();
        WaitPolicy.without(() -> which.forEach(each -> {
            Value value = values.computeIfAbsent(each.quantity.parameter(), this::read);
            each.unknown = value instanceof Value.Unknown;
            if (!each.unknown) {
                each.samples.add(time, each.quantity.in(value));
            }
        }));
        if (which.stream().anyMatch(each -> each.unknown)) {
            ask();
        }
    }

    private Value read(String parameter) {
        try {
            return bot.get(parameter);
        } catch (BotException e) {
            return Value.unknown(String.valueOf(e.getMessage()));
        }
    }

    /** Starts to ask for the values that are not reported, unless that goes on already. */
    private synchronized void ask() {
        if (!asking && bot.isConnected()) {
            asking = bot.time().tryRunAsync(bot.name() + " plots", this::askWhileUnknown);
        }
    }

    private void askWhileUnknown() {
        try {
            while (isAsking()) {
                for (Series each : series) {
                    if (each.unknown) {
                        double value = each.quantity.in(read(each.quantity.parameter()));
                        each.samples.add(seconds.applyAsDouble(bot.time().nanos()), value);
                    }
                }
                bot.time().sleep(ASKING_PERIOD_S);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private synchronized boolean isAsking() {
        asking = bot.isConnected() && series.stream().anyMatch(each -> each.unknown);
        return asking;
    }
}
