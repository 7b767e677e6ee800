package majic.team;

import java.util.List;
import java.util.function.Function;
import majic.bot.BotControl;
import majic.bot.Guard;
import majic.bot.MotionOrder;
import majic.bot.MotionReport;
import majic.driver.BegunMotion;
import majic.driver.PermittedControl;
import org.jspecify.annotations.Nullable;

/** The work of a command that is one motion. One thread may begin it, and another run it to its end. */
final class MotionWork implements QueuedCommand.Work {
    private final MotionOrder order;
    private final Guard until;
    private final Function<MotionReport, List<String>> answers;
    private volatile @Nullable BegunMotion begun;

    /**
     * @param answers makes the answers from what the motion has reported
     */
    MotionWork(MotionOrder order, Guard until, Function<MotionReport, List<String>> answers) {
        this.order = order;
        this.until = until;
        this.answers = answers;
    }

    /** Begins the motion if that waits for nothing. */
    void begin(PermittedControl robot) {
        begun = robot.begin(order, until);
    }

    @Override
    public List<String> run(BotControl robot) {
        BegunMotion first = begun;
        return answers.apply(first == null ? order.perform(robot, until) : first.finish());
    }
}
