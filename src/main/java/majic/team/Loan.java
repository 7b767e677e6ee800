package majic.team;

import java.util.List;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.MotionStopped;
import majic.bot.Permit;
import org.jspecify.annotations.Nullable;

/**
 * A temporary assignment of a robot to a borrower by its owner: the permission to move, and the queue of the borrower's
 * commands. Guarded by the lock of the robot's {@link Member}.
 */
final class Loan {
    private final Owner to;
    private final Permit lease;
    private final CommandQueue lane;
    private Permit round = new Permit();

    Loan(Owner to, Permit lease, CommandQueue lane) {
        this.to = to;
        this.lease = lease;
        this.lane = lane;
    }

    Owner to() {
        return to;
    }

    CommandQueue lane() {
        return lane;
    }

    void begin(int robot) {
        lane.start("robot " + robot + " " + to.name());
    }

    /** Closes the queue; commands still in it are not reported. */
    void close() {
        lane.close();
        lane.drop().forEach(command -> command.end(Answer.Outcome.NOT_RUN));
    }

    boolean isTo(@Nullable Owner somebody) {
        return to == somebody;
    }

    /** The permission under which the borrower's commands are carried out. */
    Permit leave(MajicBot bot) {
        return bot.permit().and(lease).and(round);
    }

    /** Ends the borrower's commands so far, at the borrower's own request; new commands are accepted. */
    List<QueuedCommand> stop() {
        round.revoke(() -> new MotionStopped("stopped"));
        round = new Permit();
        return lane.drop();
    }

    /** Revokes the permission, and with it the permission to move any robot lent under the same one. */
    void end(Supplier<? extends BotException> reason) {
        lease.revoke(reason);
    }
}
