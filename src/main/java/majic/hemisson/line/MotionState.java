package majic.hemisson.line;

import majic.hemisson.line.Question.Purpose;

/**
 * Whether the robot may move, as far as its answers show, and how it can be stopped. Guarded by its owner.
 *
 * <p>The answer to a stop is one letter. After missed answers it could be a late one to an earlier command, and it does
 * not show whether the digits arrived whole. So a robot that may have moved is asked for its speeds as well.
 */
final class MotionState {
    /** A running mode sets its speeds again within this time; those of a dance last longest (sheet 7), ns. */
    private static final long OWN_SPEEDS_NANOS = 950_000_000;

    private boolean mayMove;
    private boolean doubtful = true;
    private boolean unreached;
    private boolean brief = true;
    private boolean ownSpeeds;
    private long stoppedNanos;
    private long confirmations;
    private int disobeyed;

    /** What is to be sent after an answer. */
    enum Next {
        NOTHING,
        /** The question for its speeds. */
        VERIFY,
        /** The same question, but not without pause: its running mode may set its speeds again. */
        VERIFY_LATER,
        /** Another stop, at once. */
        STOP,
        /** Another stop, but not without pause: something else sets its speeds again and again. */
        STOP_LATER
    }

    /** Whether the wheels may turn now. */
    boolean mayMove() {
        return mayMove;
    }

    /** Whether the last question may not have arrived, so that late answers are possible. */
    boolean isDoubtful() {
        return doubtful;
    }

    /** Whether it may move, has missed an answer since it began to, and has not confirmed a stop since. */
    boolean isUnreached() {
        return unreached;
    }

    /**
     * Whether the robot may be in a state in which its motors are off and more than two characters deafen it (Hemisson
     * sheet 7). It is then asked for its speeds instead of being sent a stop.
     */
    boolean isBrief() {
        return brief;
    }

    void setsItsOwnSpeeds(boolean now) {
        ownSpeeds = now;
    }

    boolean setsItsOwnSpeeds() {
        return ownSpeeds;
    }

    /** Whether its running mode has set speeds again after a stop. */
    boolean isOverridden() {
        return ownSpeeds && disobeyed > 1;
    }

    long confirmations() {
        return confirmations;
    }

    void brief(boolean now) {
        brief = now;
    }

    void sent(Purpose purpose) {
        mayMove |= purpose == Purpose.MOTION;
    }

    void missed() {
        doubtful = true;
        unreached |= mayMove;
    }

    /** Accepts a stop without verification: older firmware cannot report its speeds (Hemisson sheet 4.3). */
    void cannotTell() {
        stands();
    }

    /** Records a reset: its motors are off, and it may run in any mode. */
    void wasReset() {
        doubtful = true;
        mayMove = false;
        unreached = false;
        disobeyed = 0;
        brief = true;
    }

    /**
     * Records an answer.
     *
     * @return what is to be sent next
     */
    Next answered(Purpose purpose, Reply reply, long nowNanos) {
        return switch (purpose) {
            case ASK, MOTION -> Next.NOTHING;
            case STOP -> stopped(nowNanos);
            case VERIFY -> verified(reply, nowNanos);
        };
    }

    private Next stopped(long nowNanos) {
        stoppedNanos = nowNanos;
        if (ownSpeeds) {
            return Next.VERIFY_LATER;
        }
        if (doubtful || mayMove) {
            return Next.VERIFY;
        }
        stands();
        return Next.NOTHING;
    }

    private void stands() {
        doubtful = false;
        mayMove = false;
        unreached = false;
        disobeyed = 0;
        confirmations++;
    }

    private Next verified(Reply reply, long nowNanos) {
        if (reply.numbers().stream().anyMatch(speed -> speed != 0)) {
            brief = false;
            disobeyed++;
            return disobeyed == 1 ? Next.STOP : Next.STOP_LATER;
        }
        if (ownSpeeds && nowNanos - stoppedNanos < OWN_SPEEDS_NANOS) {
            return Next.VERIFY_LATER;
        }
        stands();
        return Next.NOTHING;
    }
}
