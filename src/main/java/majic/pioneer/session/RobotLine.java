package majic.pioneer.session;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import majic.bot.LinkLost;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.ReportKind;
import org.jspecify.annotations.Nullable;

/** Carries commands to one robot, by packets or by a library. Any thread may send. */
public interface RobotLine {
    /**
     * Sends commands, in this order.
     *
     * @throws LinkLost if the line has ended, a command takes longer than 1 s, or the computer was suspended since the
     *     last one
     */
    void send(Packet... commands);

    /** Sends commands; throws nothing if the line has ended. */
    default void sendIfPossible(Packet... commands) {
        try {
            send(commands);
        } catch (LinkLost e) {
            Logger log = System.getLogger(RobotLine.class.getName());
            log.log(Level.DEBUG, () -> "could not send: " + e.getMessage());
        }
    }

    /** When the last command was sent, on the driver's clock; 0 before the first. */
    long sentNanos();

    /** Whether the line can carry more than SIPs; a serial port at the power-up speed cannot (ARCOS sheet 1). */
    boolean isFast();

    /** Whether the line can carry the scans of a simulator's laser beside the SIPs; a serial port is too slow. */
    default boolean carriesScans() {
        return true;
    }

    /** Whether the reports of a kind come over this line. */
    default boolean delivers(ReportKind kind) {
        return true;
    }

    /** Whether each answer of the robot to a CONFIG command is passed on. */
    default boolean passesAnswers() {
        return true;
    }

    /** Why the line has ended; null before. */
    @Nullable
    LinkLost end();

    default boolean hasEnded() {
        return end() != null;
    }

    /** Ends the line at once; discards what was not delivered yet, so that the robot cannot act on it later. */
    void abort(LinkLost cause);
}
