package majicsim.pioneer.model;

import java.util.EnumMap;
import java.util.Map;

/** The working values of all {@link Setting}s; the stored ones until a command changes them. */
public final class Settings {
    private final Map<Setting, Integer> changed = new EnumMap<>(Setting.class);

    public int get(Setting setting) {
        return changed.getOrDefault(setting, setting.stored());
    }

    public boolean isOn(Setting setting) {
        return get(setting) != 0;
    }

    public void set(Setting setting, int value) {
        changed.put(setting, value);
    }

    /** All stored values again, as at the end of a session (ARCOS sheet 5.1). */
    public void restore() {
        changed.clear();
    }
}
