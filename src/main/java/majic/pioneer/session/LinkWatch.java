package majic.pioneer.session;

import majic.bot.LinkLost;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.state.PioneerState;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * Monitors both directions of the link: sends a pulse before the robot's watchdog expires, and acts when the robot
 * stops reporting. The watchdog stops the robot after 2 s without a packet but lets it resume its last velocities at
 * the next one, so a moving robot that has stopped reporting is sent zero velocities and then nothing more (ARCOS sheet
 * 5.3).
 */
public final class LinkWatch {
    /** How often {@link #check} is called while it may find anything but a pulse that is due, seconds. */
    public static final double PERIOD_S = 0.1;

    /** With {@link #PERIOD_S} no two packets are more than 400 ms apart. */
    private static final double PULSE_S = 0.3;

    /** Between two checks, so that a pulse that is due in no time is not awaited by many of them, seconds. */
    private static final double LEAST_S = 0.004;

    private static final double HOLD_S = 0.5;

    /** Twice the usual interval between SIPs. A longer silence may count before the next pulse is due. */
    private static final double NOTICED_S = HOLD_S - PULSE_S;

    private static final double LOST_MOVING_S = 1;
    private static final double LOST_STATIONARY_S = 3;

    /** What has to be done now. */
    enum Verdict {
        /** Nothing. */
        WAIT,
        /** Send a pulse. */
        PULSE,
        /** Send zero velocities and no more pulses. */
        HOLD,
        /** Give the connection up. */
        GIVE_UP
    }

    private final RobotLine line;
    private final WheelMotors motors;
    private final TimeSource time;
    private final Signal changes;

    LinkWatch(RobotLine line, WheelMotors motors, TimeSource time, Signal changes) {
        this.line = line;
        this.motors = motors;
        this.time = time;
        this.changes = changes;
    }

    /**
     * Checks both directions once, and sends what is due.
     *
     * @param last the last state that the robot reported
     * @return why the connection has to be given up; null if it has not
     */
    @Nullable
    LinkLost check(PioneerState last) {
        motors.stopIfNotRenewed();
        boolean moving = isMoving(last);
        double silence = time.secondsSince(last.atNanos());
        switch (judge(silence, time.secondsSince(line.sentNanos()), moving)) {
            case WAIT -> {}
            case PULSE -> line.send(ArcosCommand.PULSE.packet());
            case HOLD -> holdOnce();
            case GIVE_UP -> {
                int seconds = (int) (moving ? LOST_MOVING_S : LOST_STATIONARY_S);
                return new LinkLost("connection lost: the robot has been silent for " + seconds + " s");
            }
        }
        return null;
    }

    private boolean isMoving(PioneerState last) {
        return last.isMoving() || motors.isMoving() || motors.isHeld();
    }

    /**
     * When to check again. A robot that is stationary and reports needs no check before the next pulse is due: should
     * it begin to move at once, that is still earlier than its silence counts.
     *
     * @param last the last state that the robot reported
     * @return seconds, positive
     */
    double againS(PioneerState last) {
        return againS(time.secondsSince(last.atNanos()), time.secondsSince(line.sentNanos()), isMoving(last));
    }

    /**
     * When to check again.
     *
     * @param silenceS as of {@link #judge}
     * @param unsentS as of {@link #judge}
     * @param moving as of {@link #judge}
     */
    static double againS(double silenceS, double unsentS, boolean moving) {
        return moving || silenceS > NOTICED_S ? PERIOD_S : Math.max(LEAST_S, PULSE_S - unsentS);
    }

    private void holdOnce() {
        if (!motors.isHeld()) {
            motors.hold();
            changes.raise();
        }
    }

    /**
     * Decides what has to be done.
     *
     * @param silenceS since the last SIP, seconds
     * @param unsentS since the last packet to the robot, seconds
     * @param moving whether the robot moves, has a velocity to follow, or had one when its reports stopped
     */
    static Verdict judge(double silenceS, double unsentS, boolean moving) {
        if (silenceS >= (moving ? LOST_MOVING_S : LOST_STATIONARY_S)) {
            return Verdict.GIVE_UP;
        }
        if (moving && silenceS >= HOLD_S) {
            return Verdict.HOLD;
        }
        return unsentS >= PULSE_S ? Verdict.PULSE : Verdict.WAIT;
    }
}
