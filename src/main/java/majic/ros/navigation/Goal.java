package majic.ros.navigation;

import java.util.Optional;
import java.util.OptionalDouble;
import majic.bot.LinkLost;

/** One goal of a robot, from its sending to its result. Thread-safe. */
interface Goal extends AutoCloseable {
    /** How a goal ended. */
    enum Result {
        SUCCEEDED,
        /** Cancelled by this program, by another one, or replaced by a newer goal. */
        CANCELLED,
        /** Given up or rejected by the robot. */
        FAILED
    }

    /**
     * Sends the goal; called once.
     *
     * @throws LinkLost if it could not be sent
     */
    void send();

    /** Cancels the goal; waits for nothing, and does nothing the second time. */
    void cancel();

    /** Whether the robot has reported anything about the goal. */
    boolean isAnswered();

    /** How it ended; empty while it is pursued. */
    Optional<Result> result();

    /** What the robot gave as the reason of its end; may be empty. */
    String reason();

    /** How far it still is, mm; empty if the robot does not report it. */
    OptionalDouble leftMm();

    @Override
    void close();
}
