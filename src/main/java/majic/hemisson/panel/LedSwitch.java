package majic.hemisson.panel;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Predicate;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.Value;
import majic.bot.Value.Flag.Words;
import org.jspecify.annotations.Nullable;

/**
 * Sends clicks to the robot on a background thread, one command at a time: after fast clicks the last one counts.
 * Thread-safe; a click never blocks.
 */
final class LedSwitch {
    private final BotControl bot;
    private final Executor background;
    private final Predicate<LedOrBuzzer> isOn;
    private final Consumer<String> refused;
    private final Map<LedOrBuzzer, Boolean> wanted = new EnumMap<>(LedOrBuzzer.class);
    private boolean working;

    /**
     * Sends nothing yet.
     *
     * @param background runs a task on a thread of its own
     * @param isOn whether one is on, as far as the driver can tell
     * @param refused takes the cause when one was not switched; called by the background thread
     */
    LedSwitch(BotControl bot, Executor background, Predicate<LedOrBuzzer> isOn, Consumer<String> refused) {
        this.bot = bot;
        this.background = background;
        this.isOn = isOn;
        this.refused = refused;
    }

    /** Toggles one, from the state that was requested last. */
    void toggle(LedOrBuzzer part) {
        synchronized (wanted) {
            wanted.put(part, !wanted.getOrDefault(part, isOn.test(part)));
            if (working) {
                return;
            }
            working = true;
        }
        background.execute(this::work);
    }

    /** Whether the robot has not yet confirmed a click. */
    boolean isWaiting(LedOrBuzzer part) {
        synchronized (wanted) {
            return wanted.containsKey(part);
        }
    }

    private void work() {
        for (LedOrBuzzer part = next(); part != null; part = next()) {
            boolean on = wanted(part);
            try {
                bot.set(part.parameter(), List.of(new Value.Flag(on, Words.ON_OFF)));
            } catch (BotException e) {
                refused.accept(part.parameter() + ": " + e.getMessage());
            } finally {
                synchronized (wanted) {
                    wanted.remove(part, on);
                }
            }
        }
    }

    private @Nullable LedOrBuzzer next() {
        synchronized (wanted) {
            LedOrBuzzer next = wanted.keySet().stream().findFirst().orElse(null);
            working = next != null;
            return next;
        }
    }

    private boolean wanted(LedOrBuzzer part) {
        synchronized (wanted) {
            return wanted.getOrDefault(part, false);
        }
    }
}
