package majicsim.hemisson;

import java.util.Arrays;

/** What sits on the robot's board and keeps a state: LEDs, buzzer, switches as last read, TV code, pins. */
final class Board {
    static final int LEDS = 4;
    static final int FRONT_LEFT = 2;
    static final int FRONT_RIGHT = 3;
    private static final int ON_OFF = 0;
    private static final double HEARTBEAT_SECONDS = 0.45;

    final boolean[] leds = new boolean[LEDS];
    final Pins pins = new Pins();
    boolean buzzer;
    int tvCode;
    private String switches;
    private double sinceHeartbeatSeconds;
    private String switchesSeen;

    Board(String switches) {
        this.switches = switches;
        this.switchesSeen = switches;
    }

    /** The On/Off LED blinks, whatever a command made of it (sheet 8). */
    void step(double seconds) {
        sinceHeartbeatSeconds += seconds;
        if (sinceHeartbeatSeconds >= HEARTBEAT_SECONDS) {
            sinceHeartbeatSeconds -= HEARTBEAT_SECONDS;
            leds[ON_OFF] = !leds[ON_OFF];
        }
    }

    /** Somebody moves the switches; the firmware sees it with its next round. */
    void moveSwitches(String to) {
        switches = to;
    }

    void readSwitches() {
        switchesSeen = switches;
    }

    /** Four characters in the order of command I. */
    String switches() {
        return switchesSeen;
    }

    void reset() {
        Arrays.fill(leds, false);
        pins.reset();
        buzzer = false;
        tvCode = 0;
        readSwitches();
    }
}
