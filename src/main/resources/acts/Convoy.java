import java.util.ArrayList;
import java.util.List;
import majic.act.Argument;
import majic.act.MajicAct;
import majic.act.Role;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.Unit;
import majic.bot.Value;

/**
 * One robot leads, others follow in a row straight behind it, each at its own {@code near} distance unless another is
 * given, measured by its own sensors. All move at the speed of the slowest. The leader stops while an obstacle is near
 * ahead of it, or while a follower does not detect the robot ahead of it.
 */
public final class Convoy extends MajicAct {
    private static final long serialVersionUID = 1;
    private static final double STEP_S = 0.2;
    private static final double CATCHING_UP = 1.5;

    /** The smallest {@code near} of a follower, mm; with less it hits the robot ahead of it before it has stopped. */
    private static final double SHORTEST_SIGHT_MM = 100;

    @Argument(
            value = "the distance between two robots; 0 for each follower's near",
            unit = Unit.MM,
            from = 0,
            to = 3000)
    private double distance = 0;

    @Argument(value = "the highest speed; 0 for the slowest cruise", unit = Unit.MM_PER_S, from = 0, to = 1000)
    private double speed = 0;

    private transient List<BotControl> lost = List.of();

    @Override
    public List<Role> roles() {
        return List.of(seeing(Role.ME), seeing("follower").orMore());
    }

    private static Role seeing(String name) {
        return Role.any(name).with("distanceFront", "near", "cruise");
    }

    @Override
    protected void behave() {
        List<BotControl> followers = robots("follower");
        followers.forEach(this::checkSight);
        double pace = number(bot, "cruise");
        for (BotControl follower : followers) {
            pace = Math.min(pace, number(follower, "cruise"));
        }
        pace = speed > 0 ? Math.min(speed, pace) : pace;
        while (followers.stream().anyMatch(Convoy::isBlind)) {
            pause(STEP_S);
        }
        for (; isBlind(bot) || hasRoom(bot); pause(STEP_S)) {
            tell(follow(followers, pace));
            bot.drive(lost.isEmpty() && !isBlind(bot) ? pace : 0, 0);
        }
        say("something is in the way");
    }

    private void checkSight(BotControl follower) {
        double sight = apart(follower);
        if (sight < SHORTEST_SIGHT_MM) {
            throw new BotException(follower.name() + " sees too little: its distance is " + Math.round(sight)
                    + " mm, and a follower needs " + Math.round(SHORTEST_SIGHT_MM) + " mm");
        }
    }

    /** Drives the followers and returns those that detect no robot ahead. */
    private List<BotControl> follow(List<BotControl> followers, double pace) {
        List<BotControl> blind = new ArrayList<>();
        for (BotControl follower : followers) {
            if (!follow(follower, pace)) {
                blind.add(follower);
            }
        }
        return blind;
    }

    /**
     * Drives at the leader's speed at the right distance, faster beyond it, and at zero speed at half of it. Without a
     * reading stops and returns false.
     */
    private boolean follow(BotControl robot, double pace) {
        boolean sees = robot.get("distanceFront") instanceof Value.Number;
        double half = apart(robot) / 2;
        double share = sees ? (number(robot, "distanceFront") - half) / half : 0;
        robot.drive(pace * Math.max(0, Math.min(share, CATCHING_UP)), 0);
        return sees;
    }

    private double apart(BotControl follower) {
        return distance > 0 ? distance : number(follower, "near");
    }

    private void tell(List<BotControl> blind) {
        if (!blind.equals(lost)) {
            lost = blind;
            say(blind.isEmpty() ? "together again" : blind.get(0).name() + " sees no robot ahead");
        }
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
