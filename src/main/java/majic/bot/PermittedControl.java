package majic.bot;

import java.util.List;
import java.util.function.Supplier;

/**
 * A robot that is moved under a permit which can be revoked; reading and stopping stay allowed.
 *
 * @param bot the robot
 * @param permit asked for each motion
 */
public record PermittedControl(MajicBot bot, Supplier<Permit> permit) implements BotControl {
    /**
     * A robot controlled under its own permit and an additional one.
     *
     * @param bot the robot
     * @param lease the additional permit; once it is revoked every further motion throws the exception of the
     *     revocation
     * @return the robot, for use from any thread
     */
    public static BotControl of(MajicBot bot, Permit lease) {
        return new PermittedControl(bot, () -> bot.permit().and(lease));
    }

    @Override
    public String name() {
        return bot.name();
    }

    @Override
    public MotionReport move(double mm, Guard until) {
        return bot.move(mm, until, permit.get());
    }

    @Override
    public MotionReport turn(double degrees, Guard until) {
        return bot.turn(degrees, until, permit.get());
    }

    @Override
    public MotionReport drive(double mmPerSec, double degPerSec, double seconds, Guard until) {
        return bot.drive(mmPerSec, degPerSec, seconds, until, permit.get());
    }

    @Override
    public void drive(double mmPerSec, double degPerSec) {
        bot.drive(mmPerSec, degPerSec, permit.get());
    }

    @Override
    public void stop() {
        bot.stop();
    }

    @Override
    public Value get(String parameter) {
        return bot.get(parameter);
    }

    @Override
    public void set(String parameter, List<Value> values) {
        bot.set(parameter, values, permit.get());
    }

    @Override
    public String run(String command, List<Value> arguments) {
        return bot.run(command, arguments, permit.get());
    }

    @Override
    public List<Parameter> parameters() {
        return bot.parameters();
    }

    @Override
    public List<BotCommand> commands() {
        return bot.commands();
    }
}
