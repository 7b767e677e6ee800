package majic.bot;

import java.util.List;

/**
 * Looks whether a robot would refuse a command, without commanding it: a script is checked like this before anything
 * drives off. Each method throws what the command itself would throw.
 */
public final class Checks {
    private Checks() {}

    /**
     * Checks the distance of a {@code move} against the present {@code maxMove}.
     *
     * @param bot the robot
     * @param mm how far
     * @throws ParameterException if it is too far
     */
    public static void move(MajicBot bot, double mm) {
        Pace.checkMove(mm, bot.get("maxMove").number());
    }

    /**
     * Checks the angle of a {@code turn}.
     *
     * @param degrees how far
     * @throws ParameterException if it is more than anybody can want
     */
    public static void turn(double degrees) {
        Pace.checkTurn(degrees);
    }

    /**
     * Checks a timed {@code drive} against what the robot can do.
     *
     * @param bot the robot
     * @param mmPerSec ahead positive
     * @param degPerSec counterclockwise positive
     * @param seconds for how long
     * @throws ParameterException if it is too fast or too long
     */
    public static void drive(MajicBot bot, double mmPerSec, double degPerSec, double seconds) {
        Pace.checkDrive(bot.profile(), mmPerSec, degPerSec);
        Pace.checkDriveTime(seconds);
    }

    /**
     * Checks one of the commands that only some type of robot has.
     *
     * @param bot the robot
     * @param command its name, whatever the case
     * @param arguments what it would be given
     * @return the command
     * @throws BotException if there is no such command, or it takes something else
     */
    public static BotCommand run(MajicBot bot, String command, List<Value> arguments) {
        BotCommand known = Arguments.command(bot.name(), bot.commands(), command);
        Arguments.forCommand(known, arguments);
        return known;
    }
}
