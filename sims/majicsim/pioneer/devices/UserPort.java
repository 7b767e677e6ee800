package majicsim.pioneer.devices;

import java.util.Objects;

/** The user's connector: digital inputs and outputs, and analog inputs of 0 to 5 V (ARCOS sheet 8, 11.2). */
public final class UserPort {
    /** Analog inputs that the IO packet lists; the battery comes after them. */
    public static final int ANALOG_PORTS = 8;

    private static final int ALL = 0xFF;
    private static final double FULL_SCALE_VOLTS = 5;

    private final double[] volts = new double[ANALOG_PORTS];
    private int inputs;
    private int outputs = ALL;
    private int shownPort;

    /** Closes a contact at a digital input, or opens it. */
    public void input(int bit, boolean active) {
        Objects.checkIndex(bit, Byte.SIZE);
        inputs = active ? inputs | 1 << bit : inputs & ~(1 << bit);
    }

    /** All digital inputs, active low: 0xFF with no contact closed. */
    public int digitalIn() {
        return ~inputs & ALL;
    }

    /** DIGOUT: changes the outputs that the mask chooses. */
    public void output(int states, int mask) {
        outputs = (outputs & ~mask | states & mask) & ALL;
    }

    public int digitalOut() {
        return outputs;
    }

    /** Puts a voltage on an analog input; beyond 0 to 5 V it shows the nearer end. */
    public void analog(int port, double newVolts) {
        volts[port] = Math.max(0, Math.min(FULL_SCALE_VOLTS, newVolts));
    }

    /** ADSEL: the analog port that the SIP shows. */
    public void show(int port) {
        shownPort = port & ALL;
    }

    public int shownPort() {
        return shownPort;
    }

    /** The chosen port's voltage, 255 for 5 V; 0 for a port that does not exist. */
    public int shownAnalog() {
        return shownPort < ANALOG_PORTS ? scaled(shownPort, 255) : 0;
    }

    /** A port's voltage as the IO packet has it, 1023 for 5 V. */
    public int analog(int port) {
        return scaled(port, 1023);
    }

    private int scaled(int port, int fullScale) {
        return (int) Math.round(volts[port] / FULL_SCALE_VOLTS * fullScale);
    }
}
