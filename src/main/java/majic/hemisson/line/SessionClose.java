package majic.hemisson.line;

import java.util.function.BooleanSupplier;
import majic.time.Signal;

/** Ends a connection: sends a stop and waits a moment for its confirmation (sheet 11). */
final class SessionClose {
    /** How long to wait for the confirmation, seconds; a repetition of the stop fits in. */
    private static final double PATIENCE_S = 0.8;

    private static final double LOOK_S = 0.05;

    private SessionClose() {}

    /**
     * Stops the robot and waits for the confirmation. A further stop from another thread does not undo a confirmation.
     *
     * <p>Blocks the calling thread, which also checks for overdue answers, because the robot's timer thread may have
     * ended.
     *
     * @return whether the stop was confirmed
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
