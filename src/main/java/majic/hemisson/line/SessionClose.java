package majic.hemisson.line;

import java.util.function.BooleanSupplier;
import majic.time.Signal;

/** How a connection ends: the robot is told to stand, whatever it does, and gets a moment to confirm (sheet 11). */
final class SessionClose {
    /** How long to wait for the confirmation, seconds; a repetition of the stop fits in. */
    private static final double PATIENCE_S = 0.8;

    private static final double LOOK_S = 0.05;

    private SessionClose() {}

    /**
     * Says it. Another thread may order one more stop meanwhile; that does not undo a confirmation.
     *
     * <p>It is said on the thread that closes; the robot's keeper may be gone, so overdue answers are looked for here.
     *
     * @return whether the robot has confirmed that it stands
     */
    static boolean say(HemissonSession session, Signal changes) {
        Conversation conversation = session.conversation();
        long before = conversation.confirmations();
        BooleanSupplier over = () -> session.isClosed() || conversation.confirmations() > before;
        conversation.stop();
        try {
            for (double waited = 0; waited < PATIENCE_S && !over.getAsBoolean(); waited += LOOK_S) {
                changes.await(over, LOOK_S);
                conversation.tick();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        return conversation.confirmations() > before || conversation.isStanding();
    }
}
