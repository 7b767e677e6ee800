package majic.driver;

import java.util.List;
import majic.bot.BotCommand;
import majic.bot.BotControl;
import majic.bot.Course;
import majic.bot.Guard;
import majic.bot.MotionReport;
import majic.bot.MotionStopped;
import majic.bot.Parameter;
import majic.bot.Reading;
import majic.bot.Value;

/**
 * Lets one user of a robot, such as an act or manual control, use the robot while a permit is valid. Once the permit is
 * revoked, every method but {@link #name()} throws the exception of the revocation, and nothing reaches the robot any
 * more. A motion also needs the robot's own permit, which every stop of the robot revokes. {@link #stop()} ends only
 * the motions that were begun through this object, and revokes no other permit. Thread-safe.
 */
public final class PermittedControl implements BotControl {
    private final BotDriver bot;
    private final Permit permit;
    private final Permit permitToMove;
    private Permit untilStop = new Permit();

    /**
     * Creates the control.
     *
     * @param bot the robot
     * @param permit the permit to use it, checked at each use
     */
    public PermittedControl(BotDriver bot, Permit permit) {
        this(bot, permit, permit);
    }

    private PermittedControl(BotDriver bot, Permit permit, Permit permitToMove) {
        this.bot = bot;
        this.permit = permit;
        this.permitToMove = permitToMove;
    }

    /**
     * Returns a control for one command that is queued now and begins later: it cannot move the robot once the robot
     * was stopped, its connection was lost, or {@link #endMotions()} was called here, even if the command has not begun
     * by then. Reading stays allowed as long as the permit is valid.
     *
     * @return a new control under the same permit
     */
    public PermittedControl forCommand() {
        return new PermittedControl(bot, permit, permitForMotion());
    }

    /** Ends all motions begun so far, and those of {@link #forCommand()}; later ones may begin. Sends nothing. */
    public synchronized void endMotions() {
        untilStop.revoke(() -> new MotionStopped("stopped"));
        untilStop = new Permit();
    }

    private synchronized Permit permitForMotion() {
        return permitToMove.and(untilStop).and(bot.permit());
    }

    private BotDriver permitted() {
        permit.check();
        return bot;
    }

    @Override
    public String name() {
        return bot.name();
    }

    @Override
    public MotionReport move(double mm, Guard until) {
        return permitted().move(mm, until, permitForMotion());
    }

    @Override
    public MotionReport turn(double degrees, Guard until) {
        return permitted().turn(degrees, until, permitForMotion());
    }

    @Override
    public MotionReport drive(double mmPerSec, double degPerSec, double seconds, Guard until) {
        return permitted().drive(mmPerSec, degPerSec, seconds, until, permitForMotion());
    }

    @Override
    public MotionReport follow(Course course, Guard until) {
        return permitted().follow(course, until, permitForMotion());
    }

    @Override
    public void drive(double mmPerSec, double degPerSec) {
        drive(mmPerSec, degPerSec, false);
    }

    /**
     * Drives as {@link #drive(double, double)} does, and can be guarded though the parameter {@code guard} is off.
     *
     * @param mmPerSec speed, ahead positive
     * @param degPerSec turn rate, counterclockwise positive
     * @param guarded whether the robot slows down and stops in front of obstacles in any case
     * @return the share of both speeds with which it is driven now, 0 to 1; 1 if it is not guarded
     */
    public double drive(double mmPerSec, double degPerSec, boolean guarded) {
        return permitted().drive(mmPerSec, degPerSec, guarded, permitForMotion());
    }

    @Override
    public void stop() {
        BotDriver robot = permitted();
        endMotions();
        if (robot.isConnected()) {
            robot.sendStop();
        }
    }

    @Override
    public Reading reading(String parameter) {
        return permitted().reading(parameter);
    }

    @Override
    public void set(String parameter, List<Value> values) {
        permitted().set(parameter, values, permitForMotion());
    }

    @Override
    public String run(String command, List<Value> arguments, Guard until) {
        return permitted().run(command, arguments, until, permitForMotion());
    }

    @Override
    public List<Parameter> parameters() {
        return permitted().parameters();
    }

    @Override
    public List<BotCommand> commands() {
        return permitted().commands();
    }
}
