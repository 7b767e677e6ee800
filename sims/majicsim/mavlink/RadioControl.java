package majicsim.mavlink;

import java.util.Arrays;
import majicsim.mavlink.message.Message;

/**
 * The sticks: those of the radio, or in their place those that a ground station sends, which expire (sheet 9). Channels
 * are counted from 1, their values are microseconds.
 */
final class RadioControl {
    static final int CHANNELS = 18;

    private static final int NEUTRAL = 1500;
    private static final int LOW = 1000;
    private static final int THROTTLE = 3;
    private static final int LEAVE = 65_535;
    private static final int RELEASE_UPPER = 65_534;
    private static final int FIRST_UPPER = 9;
    private static final double DEAD_ZONE = 30;
    private static final double HALF_RANGE = 400;

    private final Parameters parameters;
    private final Boot clock;
    private final int[] radio = new int[CHANNELS + 1];
    private final int[] override = new int[CHANNELS + 1];
    private final double[] overriddenS = new double[CHANNELS + 1];

    /** Sticks at rest: a copter's throttle is low, everything else neutral. */
    RadioControl(Parameters parameters, Boot clock, boolean isCopter) {
        this.parameters = parameters;
        this.clock = clock;
        for (int channel = 1; channel <= CHANNELS; channel++) {
            radio[channel] = isCopter && channel == THROTTLE ? LOW : NEUTRAL;
        }
    }

    /** The pilot moves a stick of the radio. */
    void move(int channel, int micros) {
        radio[channel] = micros;
    }

    /** RC_CHANNELS_OVERRIDE: a value of 65535 leaves a channel as it is, 0 (above channel 8: 65534) releases it. */
    void override(Message message) {
        for (int channel = 1; channel <= CHANNELS; channel++) {
            int micros = message.integer("chan" + channel + "_raw");
            boolean isUpper = channel >= FIRST_UPPER;
            if (isUpper ? micros == RELEASE_UPPER : micros == 0) {
                override[channel] = 0;
            } else if (micros != LEAVE && micros != 0) {
                override(channel, micros);
            }
        }
    }

    /** One stick of MANUAL_CONTROL, from -1000 to 1000. */
    void overrideBy(int channel, int thousandths) {
        if (Math.abs(thousandths) <= 1000) {
            override(channel, NEUTRAL + thousandths / 2);
        }
    }

    private void override(int channel, int micros) {
        override[channel] = micros;
        overriddenS[channel] = clock.seconds();
    }

    void restart() {
        Arrays.fill(override, 0);
    }

    /** What the vehicle takes as the value of a channel. */
    int micros(int channel) {
        double lastsS = parameters.get("RC_OVERRIDE_TIME");
        boolean isFresh = lastsS < 0 || clock.seconds() - overriddenS[channel] < lastsS;
        return override[channel] != 0 && isFresh ? override[channel] : radio[channel];
    }

    /** The deflection of a stick, -1 to 1. */
    double stick(int channel) {
        double off = micros(channel) - NEUTRAL;
        double beyond = Math.max(0, Math.abs(off) - DEAD_ZONE) / (HALF_RANGE - DEAD_ZONE);
        return Math.signum(off) * Math.min(1, beyond);
    }
}
