package majic.team;

import java.util.List;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.MotionStopped;
import majic.bot.Permit;
import org.jspecify.annotations.Nullable;

/**
 * A robot in the hands of somebody its owner gave it to for a while: by which leave, and the orders he gives. Guarded by
 * the lock of the robot's {@link Member}.
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

    /** Lets the lane go; nothing is said of what was still in it. */
    void close() {
        lane.close();
        lane.drop().forEach(pending -> pending.end(Answer.Outcome.NOT_RUN));
    }

    boolean isTo(@Nullable Owner somebody) {
        return to == somebody;
    }

    /** What his orders are carried out by. */
    Permit leave(MajicBot bot) {
        return bot.permit().and(lease).and(round);
    }

    /** Ends what he has ordered so far, because he says so himself; he may order anew. */
    List<QueuedCommand> stop() {
        round.revoke(() -> new MotionStopped("stopped"));
        round = new Permit();
        return lane.drop();
    }

    /** Takes the lease back, and with it the leave to move any robot that was lent by the same. */
    void end(Supplier<? extends BotException> reason) {
        lease.revoke(reason);
    }
}
