package majicsim.hemisson.board;

import java.util.Arrays;

/** The parts of the robot's board that have a state: LEDs, buzzer, switches as last read, TV code, pins. */
public final class HemissonBoard {
    public static final int LEDS = 4;
    public static final int FRONT_LEFT = 2;
    public static final int FRONT_RIGHT = 3;
    private static final int ON_OFF = 0;
    private static final double HEARTBEAT_SECONDS = 0.45;

    public final boolean[] leds = new boolean[LEDS];
    public final Pins pins = new Pins();
    public boolean buzzer;
    public int tvCode;
    private String switches;
    private double sinceHeartbeatSeconds;
    private String switchesSeen;

    public HemissonBoard(String switches) {
        this.switches = switches;
        this.switchesSeen = switches;
    }

    /** Makes the On/Off LED blink, independent of commands (sheet 8). */
    public void step(double seconds) {
        sinceHeartbeatSeconds += seconds;
        if (sinceHeartbeatSeconds >= HEARTBEAT_SECONDS) {
            sinceHeartbeatSeconds -= HEARTBEAT_SECONDS;
            leds[ON_OFF] = !leds[ON_OFF];
        }
    }

    /** Moves the switches; the firmware reads them in its next round. */
    public void moveSwitches(String to) {
        switches = to;
    }

    public void readSwitches() {
        switchesSeen = switches;
    }

    /** Four characters in the order of command I. */
    public String switches() {
        return switchesSeen;
    }

    public void reset() {
        Arrays.fill(leds, false);
        pins.reset();
        buzzer = false;
        tvCode = 0;
        readSwitches();
    }
}
