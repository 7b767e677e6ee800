package majicsim.pioneer.devices;

import majicsim.pioneer.model.Setting;
import majicsim.pioneer.model.Settings;

/**
 * The red STOP button: with E_STALL on, as it is at first, it stalls and disables the motors while pressed (ARCOS sheet
 * 6.1, 8.1).
 */
public final class StopButton {
    private static final int PRESSED_FLAG = 1 << 5;
    private static final int E_STALL_FLAG = 1 << 6;

    private final Settings settings;
    private boolean pressed;

    StopButton(Settings settings) {
        this.settings = settings;
    }

    public void press(boolean down) {
        pressed = down;
    }

    /** Whether the motors must be off. */
    public boolean holdsMotors() {
        return pressed && settings.isOn(Setting.E_STALL);
    }

    /** Bits 5 and 6 of FLAGS. */
    public int flags() {
        return (pressed ? PRESSED_FLAG : 0) | (holdsMotors() ? E_STALL_FLAG : 0);
    }
}
