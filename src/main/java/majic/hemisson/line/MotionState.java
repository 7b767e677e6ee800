package majic.hemisson.line;

import majic.hemisson.line.Question.Purpose;

/** Whether the robot may move, as far as its answers show. Guarded by its owner. */
final class MotionState {
    private boolean mayMove;
    private boolean doubtful = true;
    private boolean unreached;
    private long confirmations;

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

    /** How often the robot has confirmed that it is stopped. */
    long confirmations() {
        return confirmations;
    }

    /** Records that a question is sent. */
    void sent(Purpose purpose) {
        mayMove |= purpose == Purpose.MOTION;
    }

    /** Records that a late answer to an earlier question is possible. */
    void doubt() {
        doubtful = true;
    }

    /** Records that an answer is missing. */
    void missed() {
        doubt();
        unreached |= mayMove;
    }

    /** Records that a stop is confirmed. */
    void stopped() {
        doubtful = false;
        mayMove = false;
        unreached = false;
        confirmations++;
    }

    /** Records a reset: the motors are off, and answers to earlier questions are still possible. */
    void wasReset() {
        doubtful = true;
        mayMove = false;
        unreached = false;
    }
}
