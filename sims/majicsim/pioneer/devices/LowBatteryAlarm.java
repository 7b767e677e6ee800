package majicsim.pioneer.devices;

import majicsim.pioneer.model.Setting;
import majicsim.pioneer.model.Settings;

/** Beeps every few seconds while the battery is below LOWBATTERY, unless a tune is playing. */
final class LowBatteryAlarm {
    private static final long EVERY_NANOS = 5_000_000_000L;
    /** A fifth of a second of 1760 Hz. */
    private static final byte[] BEEP = {10, 93};

    private final Settings settings;
    private final Battery battery;
    private final Buzzer buzzer;
    private long quietNanos = EVERY_NANOS;

    LowBatteryAlarm(Settings settings, Battery battery, Buzzer buzzer) {
        this.settings = settings;
        this.battery = battery;
        this.buzzer = buzzer;
    }

    void step(long nanos) {
        quietNanos += nanos;
        boolean low = battery.tenthVolts() < settings.get(Setting.LOW_BATTERY);
        if (low && quietNanos >= EVERY_NANOS && !buzzer.isPlaying()) {
            quietNanos = 0;
            buzzer.say(BEEP);
        }
    }
}
