import java.util.List;
import majic.act.MajicAct;
import majic.act.Role;
import majic.bot.BotControl;
import majic.bot.Value;

/**
 * One robot leads, another follows straight behind it at the distance that counts as near for it, by its own sensors.
 * The leader stands when something is near ahead of it, or when who follows has lost sight of it.
 */
public final class Convoy extends MajicAct {
    private static final long serialVersionUID = 1;
    private static final double STEP_S = 0.2;
    private static final double CATCHING_UP = 1.5;

    @Override
    public List<Role> roles() {
        return List.of(seeing(Role.ME), seeing("follower"));
    }

    private static Role seeing(String name) {
        return Role.any(name).with("distanceFront", "near", "cruise");
    }

    @Override
    protected void behave() {
        double pace = number(bot, "cruise");
        for (boolean together = true; isBlind(bot) || hasRoom(bot); pause(STEP_S)) {
            if (together != follow(robot("follower"), pace)) {
                together = !together;
                say(together ? "together again" : "the follower sees nobody ahead");
            }
            bot.drive(together && !isBlind(bot) ? pace : 0, 0);
        }
        say("something is in the way");
    }

    /** As fast as the leader at the right distance, not at all at half of it; stands, and says no, without a sight. */
    private static boolean follow(BotControl robot, double pace) {
        boolean sees = robot.get("distanceFront") instanceof Value.Number;
        double half = number(robot, "near") / 2;
        double share = sees ? (number(robot, "distanceFront") - half) / half : 0;
        robot.drive(pace * Math.max(0, Math.min(share, CATCHING_UP)), 0);
        return sees;
    }

    private static boolean hasRoom(BotControl robot) {
        return number(robot, "distanceFront") > number(robot, "near");
    }

    private static boolean isBlind(BotControl robot) {
        return robot.get("distanceFront") instanceof Value.Unknown;
    }

    private static double number(BotControl robot, String parameter) {
        return robot.get(parameter).number();
    }
}
