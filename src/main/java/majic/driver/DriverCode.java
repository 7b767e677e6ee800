package majic.driver;

import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.text.ClassReason;

/**
 * Calls what a driver implements, which may be code of a plug-in: a library that it lacks is often missed only when its
 * code first runs.
 */
final class DriverCode {
    private DriverCode() {}

    /**
     * Calls it.
     *
     * @throws BotException that names the class, if one cannot be loaded; what the code throws otherwise
     */
    static <T> T call(MajicBot bot, Supplier<T> code) {
        try {
            return code.get();
        } catch (LinkageError e) {
            throw new BotException(bot.name() + ": the driver cannot be loaded: " + ClassReason.of(e), e);
        }
    }

    /** As {@link #call}, without a result. */
    static void run(MajicBot bot, Runnable code) {
        call(bot, () -> {
            code.run();
            return true;
        });
    }
}
