package majic.pioneer;

/**
 * What to do about a robot's silence, and about ours. The robot's watchdog stops it after 2 s without a packet but lets
 * it take up its last velocities at the next one, so a silent robot that moves must hear of zero first and then nothing
 * more (ARCOS sheet 5.3).
 */
final class LinkWatch {
    /** How often to look, seconds; with {@link #PULSE_S} no two packets are more than 400 ms apart. */
    static final double PERIOD_S = 0.1;

    private static final double PULSE_S = 0.25;
    private static final double HOLD_S = 0.5;
    static final double LOST_MOVING_S = 1;
    static final double LOST_STANDING_S = 3;

    /** What is to be done now. */
    enum Verdict {
        /** Nothing. */
        WAIT,
        /** Send a pulse. */
        PULSE,
        /** Send zero velocities and no more pulses. */
        HOLD,
        /** Give the line up. */
        GIVE_UP
    }

    private LinkWatch() {}

    /**
     * Judges.
     *
     * @param silenceS since the last SIP, seconds
     * @param unsentS since the last packet to the robot, seconds
     * @param moving whether the robot moves or was told to, or did when it fell silent
     */
    static Verdict judge(double silenceS, double unsentS, boolean moving) {
        if (silenceS >= (moving ? LOST_MOVING_S : LOST_STANDING_S)) {
            return Verdict.GIVE_UP;
        }
        if (moving && silenceS >= HOLD_S) {
            return Verdict.HOLD;
        }
        return unsentS >= PULSE_S ? Verdict.PULSE : Verdict.WAIT;
    }
}
