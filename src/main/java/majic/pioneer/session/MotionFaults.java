package majic.pioneer.session;

import majic.pioneer.state.Bumpers;
import majic.pioneer.state.Equipment;
import majic.pioneer.state.PioneerState;
import org.jspecify.annotations.Nullable;

/**
 * Finds what ends a motion from the robot's side: stall, bumper, a step down, motors off, the STOP button. For one
 * motion.
 */
public final class MotionFaults {
    /** Stall bits of an earlier motion may remain set until the wheels turn again (ARCOS sheet 7.5), seconds. */
    private static final double OLD_STALL_S = 1;

    /** Motors that a drive switches on are on after this time, seconds. */
    private static final double SWITCH_ON_S = 1;

    private final Equipment equipment;
    private final Direction direction;
    private final PioneerState start;
    private boolean seenFree;
    private boolean seenOn;

    /** Which end of the robot is in front. */
    enum Direction {
        /** Ahead. */
        AHEAD,
        /** Backward. */
        BACK,
        /** On the spot. */
        AROUND;

        /** The direction of a speed, mm/s. */
        static Direction of(double mmPerSec) {
            return mmPerSec > 0 ? AHEAD : mmPerSec < 0 ? BACK : AROUND;
        }
    }

    MotionFaults(Equipment equipment, Direction direction, PioneerState start) {
        this.equipment = equipment;
        this.direction = direction;
        this.start = start;
    }

    /**
     * Checks a state that was reported during the motion.
     *
     * @param seconds since the motion began
     * @return the reason to end it, as half a sentence; null if there is none
     */
    @Nullable
    String check(PioneerState now, double seconds) {
        seenFree |= !now.stalled();
        seenOn |= now.motorsOn();
        if (now.stopButton()) {
            return "STOP button pressed";
        }
        if (now.stopEngaged()) {
            return "emergency stop engaged";
        }
        if (!now.motorsOn() && (seenOn || seconds > SWITCH_ON_S)) {
            return seenOn ? "motors switched off" : "motors do not switch on";
        }
        if (now.stalled() && (seenFree || seconds > OLD_STALL_S)) {
            return "stalled";
        }
        return bumped(now);
    }

    private @Nullable String bumped(PioneerState now) {
        boolean front = equipment.bumpers().front(now) != 0;
        boolean rear = equipment.bumpers().rear(now) != 0;
        return switch (direction) {
            case AHEAD -> front ? "front bumper touched" : stepAhead(now);
            case BACK -> rear ? "rear bumper touched" : null;
            case AROUND -> isNewlyTouched(now) ? "bumper touched" : null;
        };
    }

    /** The flag of a robot without such sensors may be set all the time, so only a change counts. */
    private @Nullable String stepAhead(PioneerState now) {
        return now.ledge() && !start.ledge() ? "the robot looks down a step" : null;
    }

    private boolean isNewlyTouched(PioneerState now) {
        Bumpers bumpers = equipment.bumpers();
        return (bumpers.front(now) & ~bumpers.front(start)) != 0 || (bumpers.rear(now) & ~bumpers.rear(start)) != 0;
    }
}
