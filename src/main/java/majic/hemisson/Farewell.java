package majic.hemisson;

import majic.bot.Signal;

/** How a connection ends: the robot is told to stand, whatever it does, and gets a moment to confirm (sheet 11). */
final class Farewell {
    /** How long to wait for the confirmation, seconds; a repetition of the stop fits in. */
    private static final double PATIENCE_S = 0.8;

    private static final double LOOK_S = 0.05;

    private Farewell() {}

    /**
     * Says it on the thread that closes; the robot's keeper may be gone, so overdue answers are looked for here.
     *
     * @return whether the robot has confirmed that it stands
     */
    static boolean say(Session session, Signal changes) {
        Conversation conversation = session.conversation();
        conversation.stop();
        try {
            for (double waited = 0; waited < PATIENCE_S && !isOver(session); waited += LOOK_S) {
                changes.await(() -> isOver(session), LOOK_S);
                conversation.tick();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        return conversation.isStanding();
    }

    private static boolean isOver(Session session) {
        return session.isClosed() || session.conversation().isStanding();
    }
}
