package majic.nav;

import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.Value;
import majic.time.WaitPolicy;

/**
 * The distance from the hull of a robot to what is ahead of it or behind it, as a robot without described range sensors
 * measures it.
 */
final class HullDistance {
    private final MajicBot robot;
    private final String parameter;
    private final double sign;

    private HullDistance(MajicBot robot, String parameter, double sign) {
        this.robot = robot;
        this.parameter = parameter;
        this.sign = sign;
    }

    static HullDistance ahead(MajicBot robot) {
        return new HullDistance(robot, "distanceFront", 1);
    }

    static HullDistance behind(MajicBot robot) {
        return new HullDistance(robot, "distanceBack", -1);
    }

    /** Returns the parameter that has it. */
    String parameter() {
        return parameter;
    }

    /** Returns whether the robot measures it. */
    boolean isMeasured() {
        return robot.parameters().stream().anyMatch(one -> one.name().equals(parameter));
    }

    /** Returns the distance now, without waiting for it: a number of mm, clear or unknown. */
    Value now() {
        Value[] now = {Value.CLEAR};
        WaitPolicy.without(() -> now[0] = read());
        return now[0];
    }

    private Value read() {
        try {
            return robot.get(parameter);
        } catch (BotException e) {
            return Value.unknown(String.valueOf(e.getMessage()));
        }
    }

    /** Returns how far ahead of the centre of the robot a thing at a distance from its hull is; negative if behind. */
    double fromCentreMm(Value.Number distance) {
        return sign * (robot.profile().bodyMm() + distance.amount());
    }
}
