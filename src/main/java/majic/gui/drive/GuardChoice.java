package majic.gui.drive;

import java.util.Optional;
import majic.environment.Settings;
import majic.gui.kit.BackgroundSettings;

/**
 * Whether driving by hand is guarded: on until it is switched off, which is kept. Used on the event dispatch thread.
 */
public final class GuardChoice {
    private static final String KEY = "drive.guard";
    private static final String OFF = "off";

    private final Settings settings;
    private boolean on;

    /** The choice that was made last. */
    public GuardChoice(Settings settings) {
        this.settings = settings;
        on = !settings.get(KEY).equals(Optional.of(OFF));
    }

    boolean isOn() {
        return on;
    }

    void choose(boolean wanted) {
        on = wanted;
        BackgroundSettings.put(settings, KEY, wanted ? "on" : OFF);
    }
}
