package majic.act;

import java.util.List;
import majic.bot.BotCommand;
import majic.bot.BotControl;
import majic.bot.Guard;
import majic.bot.MajicBot;
import majic.bot.MotionReport;
import majic.bot.MotionStopped;
import majic.bot.Parameter;
import majic.bot.Permit;
import majic.bot.PermittedControl;
import majic.bot.Value;

/**
 * Lets an act use a robot while its permission is valid. After that is revoked, every method but the name throws, and
 * nothing reaches the robot any more. A stop by the act ends only the motions that the act has begun, and revokes no
 * other permission. Thread-safe.
 */
final class Lease implements BotControl {
    private final Permit permit;
    private final MajicBot robot;
    private Permit round = new Permit();

    Lease(MajicBot robot, Permit permit) {
        this.permit = permit;
        this.robot = robot;
    }

    private synchronized BotControl robot() {
        permit.check();
        return PermittedControl.of(robot, permit.and(round));
    }

    @Override
    public String name() {
        return robot.name();
    }

    @Override
    public MotionReport move(double mm, Guard until) {
        return robot().move(mm, until);
    }

    @Override
    public MotionReport turn(double degrees, Guard until) {
        return robot().turn(degrees, until);
    }

    @Override
    public MotionReport drive(double mmPerSec, double degPerSec, double seconds, Guard until) {
        return robot().drive(mmPerSec, degPerSec, seconds, until);
    }

    @Override
    public void drive(double mmPerSec, double degPerSec) {
        robot().drive(mmPerSec, degPerSec);
    }

    @Override
    public void stop() {
        endRound();
        if (robot.isConnected()) {
            robot.sendStop();
        }
    }

    private synchronized void endRound() {
        permit.check();
        round.revoke(() -> new MotionStopped("stopped"));
        round = new Permit();
    }

    @Override
    public Value get(String parameter) {
        return robot().get(parameter);
    }

    @Override
    public void set(String parameter, List<Value> values) {
        robot().set(parameter, values);
    }

    @Override
    public String run(String command, List<Value> arguments) {
        return robot().run(command, arguments);
    }

    @Override
    public List<Parameter> parameters() {
        return robot().parameters();
    }

    @Override
    public List<BotCommand> commands() {
        return robot().commands();
    }
}
