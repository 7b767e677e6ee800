package majicsim.pioneer.model;

/** The working values of all {@link Setting}s; the stored ones until a command changes them. */
public final class Settings {
    private static final Setting[] ALL = Setting.values();

    private final int[] values = new int[ALL.length];

    /** Begins with the stored values. */
    public Settings() {
        restore();
    }

    public int get(Setting setting) {
        return values[setting.ordinal()];
    }

    public boolean isOn(Setting setting) {
        return get(setting) != 0;
    }

    public void set(Setting setting, int value) {
        values[setting.ordinal()] = value;
    }

    /** All stored values again, as at the end of a session (ARCOS sheet 5.1). */
    public void restore() {
        for (Setting setting : ALL) {
            values[setting.ordinal()] = setting.stored();
        }
    }
}
