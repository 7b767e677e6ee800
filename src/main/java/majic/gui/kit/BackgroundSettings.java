package majic.gui.kit;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.Optional;
import majic.bot.BotException;
import majic.environment.Settings;

/** Stores settings without blocking the window. One that cannot be written holds until the program ends. */
public final class BackgroundSettings {
    private static final Logger LOG = System.getLogger(BackgroundSettings.class.getName());

    private BackgroundSettings() {}

    /** Stores a setting in the background, unless it has this value already. */
    public static void put(Settings settings, String key, String value) {
        EventThread.background("storing " + key, () -> write(settings, key, value));
    }

    private static void write(Settings settings, String key, String value) {
        try {
            if (!settings.get(key).equals(Optional.of(value))) {
                settings.put(key, value);
            }
        } catch (BotException e) {
            LOG.log(Level.DEBUG, key + " is not stored for the next start", e);
        }
    }
}
