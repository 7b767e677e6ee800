package majic.pioneer.session;

import majic.bot.LinkLost;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.state.PioneerState;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * What to do about a robot's silence, and about ours. The robot's watchdog stops it after 2 s without a packet but lets
 * it take up its last velocities at the next one, so a silent robot that moves must hear of zero first and then nothing
 * more (ARCOS sheet 5.3).
 */
public final class LinkWatch {
    /** How often to look, seconds; with {@link #PULSE_S} no two packets are more than 400 ms apart. */
    public static final double PERIOD_S = 0.1;

    private static final double PULSE_S = 0.25;
    private static final double HOLD_S = 0.5;
    private static final double LOST_MOVING_S = 1;
    private static final double LOST_STANDING_S = 3;

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

    private final ArcosLine line;
    private final VelocitySetpoint wheels;
    private final TimeSource time;
    private final Signal changes;

    LinkWatch(ArcosLine line, VelocitySetpoint wheels, TimeSource time, Signal changes) {
        this.line = line;
        this.wheels = wheels;
        this.time = time;
        this.changes = changes;
    }

    /**
     * Looks once, and sends what is due.
     *
     * @param last what the robot said last
     * @return why the line is to be given up; null if it is not
     */
    @Nullable
    LinkLost look(PioneerState last) {
        wheels.standIfForgotten();
        boolean moving = last.isMoving() || wheels.areDriven() || wheels.areHeld();
        double silence = time.secondsSince(last.atNanos());
        switch (judge(silence, time.secondsSince(line.sentNanos()), moving)) {
            case WAIT -> {}
            case PULSE -> line.send(ArcosCommand.PULSE.packet());
            case HOLD -> holdOnce();
            case GIVE_UP -> {
                int seconds = (int) (moving ? LOST_MOVING_S : LOST_STANDING_S);
                return new LinkLost("connection lost: the robot has been silent for " + seconds + " s");
            }
        }
        return null;
    }

    private void holdOnce() {
        if (!wheels.areHeld()) {
            wheels.hold();
            changes.raise();
        }
    }

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
