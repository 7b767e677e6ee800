package majic.nav;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.Guard;
import majic.bot.MajicBot;
import majic.bot.MotionReport;
import majic.bot.Pose;
import majic.bot.Unit;
import majic.bot.Value;
import majic.nav.grid.NavigationMap;
import majic.nav.path.Way;

/**
 * Sends robots to places: around the walls of a map if there is one, around what their sensors see, and around the
 * other robots that it knows. Thread-safe.
 *
 * <p>A robot of which {@link #add} was never called can be sent as well; the others do not know of it while it stands.
 */
public final class Navigator {
    /** The word of the command by which a robot goes to a place by its own navigation, if it has one. */
    private static final String OWN = "goto";

    /** A frontier as near to one that another robot drives to is left to that robot, mm. */
    private static final double SHARE_MM = 2000;

    private final TeamSpace space;
    private final Map<MajicBot, Pose> frontiers = new ConcurrentHashMap<>();

    /** Sends robots in the open, where there is no map. */
    public Navigator() {
        this(Optional::empty);
    }

    /**
     * Sends robots on a map.
     *
     * @param map asked again and again; empty while there is none
     */
    public Navigator(Supplier<Optional<NavigationMap>> map) {
        this.space = new TeamSpace(map);
    }

    /**
     * Takes note of a robot, so that others drive around it where it stands, if it was placed, and finds obstacles for
     * it when it is guarded.
     *
     * @param robot any
     */
    public void add(MajicBot robot) {
        space.add(robot);
        robot.useGuard(new ObstacleGuard(robot, space));
    }

    /**
     * Forgets a robot.
     *
     * @param robot one that was added
     */
    public void remove(MajicBot robot) {
        space.remove(robot);
        robot.useGuard(null);
    }

    /**
     * Sets what asks robots that stand in the way of others to make room. Without this call no robot is asked; the
     * navigator of a session asks the robots of its team.
     *
     * @param asks is asked for robots whose parameter {@code giveWay} is on, by motions that begin from now on
     */
    public void useGiveWay(GiveWay asks) {
        space.useGiveWay(asks);
    }

    /**
     * Drives to a place and returns when the robot is stationary again.
     *
     * @param robot connected; if there is a map, placed on it
     * @param destination in the frame of the robot's poses
     * @return the place that it has reached
     * @throws majic.bot.MotionFailed if there is no way, something stands in the way for too long, or the robot does
     *     not know well enough where it is; it stands
     * @throws BotException as for any motion
     */
    public MotionReport goTo(MajicBot robot, Destination destination) {
        return goTo(robot, robot, destination, Guard.NEVER);
    }

    /**
     * Drives to a place under a permit.
     *
     * @param robot as in {@link #goTo(MajicBot, Destination)}
     * @param control commands that robot
     * @param destination in the frame of the robot's poses
     * @param until ends the motion early
     * @return the place that it has reached
     */
    public MotionReport goTo(MajicBot robot, BotControl control, Destination destination, Guard until) {
        if (hasOwnNavigation(robot)) {
            return byItself(robot, control, destination, until);
        }
        try (GoalCourse course = new GoalCourse(robot, destination, space)) {
            return control.follow(course, until);
        }
    }

    /**
     * Returns whether a robot goes to places by a navigation of its own.
     *
     * @param robot any
     * @return true if it has the command {@code goto}
     */
    public static boolean hasOwnNavigation(MajicBot robot) {
        return robot.commands().stream().anyMatch(command -> command.name().equalsIgnoreCase(OWN));
    }

    private static MotionReport byItself(MajicBot robot, BotControl control, Destination destination, Guard until) {
        Pose pose = destination.pose();
        Value x = Value.of(pose.xMm(), Unit.MM);
        Value y = Value.of(pose.yMm(), Unit.MM);
        List<Value> values =
                destination.withHeading() ? List.of(x, y, Value.of(pose.headingDeg(), Unit.DEG)) : List.of(x, y);
        long begunNanos = robot.time().nanos();
        control.run(OWN, values, until);
        return new MotionReport(GoalCourse.place(robot), robot.time().secondsSince(begunNanos));
    }

    /**
     * Returns the way that a robot still has.
     *
     * @param robot any
     * @return empty if it does not drive to a place by this navigator
     */
    public Optional<Way> way(MajicBot robot) {
        return space.traffic().way(robot);
    }

    /**
     * Returns the places that a robot has reserved for itself, the one where it is first.
     *
     * @param robot any
     * @return none if it does not drive to a place by this navigator
     */
    public List<Pose> reserved(MajicBot robot) {
        return space.traffic().reserved(robot);
    }

    /**
     * Returns why a robot stands on its way.
     *
     * @param robot any
     * @return empty while it drives, and if it does not drive to a place by this navigator
     */
    public Optional<Wait> waits(MajicBot robot) {
        return space.traffic().waits(robot);
    }

    /** Returns whether another robot drives to a frontier, or to one that is close to it. */
    boolean isTaken(MajicBot robot, Pose frontier) {
        return frontiers.entrySet().stream()
                .anyMatch(other -> other.getKey() != robot && other.getValue().distanceMm(frontier) < SHARE_MM);
    }

    /** Takes a frontier for a robot until {@link #giveUpFrontier}; returns false if another one has taken it. */
    boolean takeFrontier(MajicBot robot, Pose frontier) {
        synchronized (frontiers) {
            boolean free = !isTaken(robot, frontier);
            if (free) {
                frontiers.put(robot, frontier);
            }
            return free;
        }
    }

    void giveUpFrontier(MajicBot robot) {
        frontiers.remove(robot);
    }

    /** Returns what the courses of its robots go by. */
    TeamSpace space() {
        return space;
    }
}
