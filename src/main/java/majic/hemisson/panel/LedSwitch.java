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
    void toggle(LedOrBuzzer lamp) {
        synchronized (wanted) {
            wanted.put(lamp, !wanted.getOrDefault(lamp, isOn.test(lamp)));
            if (working) {
                return;
            }
            working = true;
        }
        background.execute(this::work);
    }

    /** Whether the robot has not yet confirmed a click. */
    boolean isWaiting(LedOrBuzzer lamp) {
        synchronized (wanted) {
            return wanted.containsKey(lamp);
        }
    }

    private void work() {
        for (LedOrBuzzer lamp = next(); lamp != null; lamp = next()) {
            boolean on = wish(lamp);
            try {
                bot.set(lamp.parameter(), List.of(new Value.Flag(on, Words.ON_OFF)));
            } catch (BotException e) {
                refused.accept(lamp.parameter() + ": " + e.getMessage());
            } finally {
                synchronized (wanted) {
                    wanted.remove(lamp, on);
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

    private boolean wish(LedOrBuzzer lamp) {
        synchronized (wanted) {
            return wanted.getOrDefault(lamp, false);
        }
    }
}
