package majicsim.pioneer.devices;

/** The controller's temperature, and the warning when it gets too hot (ARCOS sheet 8, FAULT_FLAGS and TEMPERATURE). */
public final class Thermometer {
    /** Where a controller would switch itself off, as CONFIG reports; this one only warns, 10 degrees earlier. */
    public static final int SHUTDOWN_CELSIUS = 75;

    private static final int WARNING_CELSIUS = SHUTDOWN_CELSIUS - 10;
    private static final int WARNING_FAULT = 1 << 1;
    private static final int ROOM_CELSIUS = 25;

    private int celsius = ROOM_CELSIUS;

    public void set(int newCelsius) {
        celsius = newCelsius;
    }

    public int celsius() {
        return celsius;
    }

    /** FAULT_FLAGS. */
    public int faults() {
        return celsius >= WARNING_CELSIUS ? WARNING_FAULT : 0;
    }
}
