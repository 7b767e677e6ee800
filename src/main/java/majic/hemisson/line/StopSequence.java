package majic.hemisson.line;

import majic.hemisson.line.Question.Purpose;

/**
 * Determines by which command the robot is stopped, and what is sent after each answer until it is known to be stopped.
 * Guarded by its owner.
 *
 * <p>The answer to a stop is one letter. After missed answers it could be a late one to an earlier command, and it does
 * not show whether the digits arrived whole. So a robot that may have moved is asked for its speeds as well.
 */
final class StopSequence {
    /** A running mode sets its speeds again within this time; those of a dance last longest (Hemisson sheet 7), ns. */
    private static final long OWN_SPEEDS_NANOS = 950_000_000;

    private final MotionState motion;
    private boolean deafenable = true;
    private boolean ownSpeeds;
    private long stoppedNanos;
    private int disobeyed;

    /** What is to be sent after an answer. */
    enum Next {
        NOTHING,
        /** The question for its speeds. */
        VERIFY,
        /** The same question, after a pause: its running mode may set its speeds again. */
        VERIFY_LATER,
        /** Another stop, at once. */
        STOP,
        /** Another stop, after a pause: something else sets its speeds again and again. */
        STOP_LATER
    }

    /**
     * Starts with a robot of which nothing is known.
     *
     * @param motion receives each confirmed stop
     */
    StopSequence(MotionState motion) {
        this.motion = motion;
    }

    /**
     * Whether the robot may be in a state in which its motors are off and more than two characters deafen it (Hemisson
     * sheet 7).
     */
    boolean isDeafenable() {
        return deafenable;
    }

    void setDeafenable(boolean now) {
        deafenable = now;
    }

    boolean hasOwnSpeeds() {
        return ownSpeeds;
    }

    void setOwnSpeeds(boolean now) {
        ownSpeeds = now;
    }

    /** Whether its running mode has set speeds again after a stop. */
    boolean isOverridden() {
        return ownSpeeds && disobeyed > 1;
    }

    /** The command that stops the robot; a robot that may be deafened is asked for its speeds instead. */
    Question stop() {
        return deafenable ? Question.VERIFY : Question.STOP;
    }

    /**
     * Records an answer.
     *
     * @return what is to be sent next
     */
    Next answered(Purpose purpose, Reply reply, long nowNanos) {
        return switch (purpose) {
            case ASK, MOTION -> Next.NOTHING;
            case STOP -> stopAnswered(nowNanos);
            case VERIFY -> speedsAnswered(reply, nowNanos);
        };
    }

    private Next stopAnswered(long nowNanos) {
        stoppedNanos = nowNanos;
        if (ownSpeeds) {
            return Next.VERIFY_LATER;
        }
        if (motion.isDoubtful() || motion.mayMove()) {
            return Next.VERIFY;
        }
        confirmed();
        return Next.NOTHING;
    }

    private Next speedsAnswered(Reply reply, long nowNanos) {
        if (reply.numbers().stream().anyMatch(speed -> speed != 0)) {
            deafenable = false;
            disobeyed++;
            return disobeyed == 1 ? Next.STOP : Next.STOP_LATER;
        }
        if (ownSpeeds && nowNanos - stoppedNanos < OWN_SPEEDS_NANOS) {
            return Next.VERIFY_LATER;
        }
        confirmed();
        return Next.NOTHING;
    }

    /** Records that the robot refused the question for its speeds: older firmware cannot report them (sheet 4.3). */
    void speedsRefused() {
        confirmed();
    }

    private void confirmed() {
        disobeyed = 0;
        motion.stopped();
    }

    /** Records a reset: it may run in any mode from now on. */
    void wasReset() {
        motion.wasReset();
        disobeyed = 0;
        deafenable = true;
    }
}
