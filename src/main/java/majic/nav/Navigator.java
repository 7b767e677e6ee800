package majic.nav;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.Guard;
import majic.bot.MajicBot;
import majic.bot.MotionReport;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.Unit;
import majic.bot.Value;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.OccupancyGrid;
import majic.nav.path.FreeSpace;
import majic.nav.path.ObstacleDistance;
import majic.nav.path.Way;
import org.jspecify.annotations.Nullable;

/**
 * Sends robots to places: around the walls of a map if there is one, around what their sensors see, and around the
 * other robots that it knows. Thread-safe.
 *
 * <p>A robot of which {@link #add} was never called can be sent as well; the others do not know of it while it stands.
 */
public final class Navigator {
    /** The word of the command by which a robot goes to a place by its own navigation, if it has one. */
    private static final String OWN = "goto";

    /** Without a map, what lies as far beside the way counts as room to drive around something, mm. */
    private static final double BESIDE_MM = 5000;

    /** An echo as near to the hull of another robot is of that robot. */
    static final double HULL_MM = 200;

    private static final double FARTHEST_WITHOUT_MAP_MM = 100_000;
    private static final double CELL_WITHOUT_MAP_MM = 100;

    /** A frontier as near to one that another robot drives to is left to that robot, mm. */
    private static final double SHARE_MM = 2000;

    /** A map that grows is looked at as often, seconds. */
    private static final double MAP_S = 2;

    private final Supplier<Optional<NavigationMap>> map;
    private final Set<MajicBot> robots = ConcurrentHashMap.newKeySet();
    private final TeamTraffic traffic = new TeamTraffic();
    private final Map<MajicBot, Pose> frontiers = new ConcurrentHashMap<>();
    private @Nullable NavigationMap measured;
    private @Nullable ObstacleDistance distances;
    private long measuredNanos;

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
        this.map = map;
    }

    /**
     * Takes note of a robot, so that others drive around it where it stands, if it was placed, and finds obstacles for
     * it when it is guarded.
     *
     * @param robot any
     */
    public void add(MajicBot robot) {
        robots.add(robot);
        robot.useGuard(new ObstacleGuard(robot, this));
    }

    /**
     * Forgets a robot.
     *
     * @param robot one that was added
     */
    public void remove(MajicBot robot) {
        robots.remove(robot);
        robot.useGuard(null);
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
        try (GoalCourse course = new GoalCourse(robot, destination, this)) {
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
        return new MotionReport(place(robot), robot.time().secondsSince(begunNanos));
    }

    /** Returns where a robot is, as answers show it. */
    static Value place(MajicBot robot) {
        Pose here = robot.state().pose();
        return Value.many(List.of(
                Value.of(here.xMm(), Unit.MM), Value.of(here.yMm(), Unit.MM), Value.of(here.headingDeg(), Unit.DEG)));
    }

    /**
     * Returns the way that a robot still has.
     *
     * @param robot any
     * @return empty if it does not drive to a place by this navigator
     */
    public Optional<Way> way(MajicBot robot) {
        return traffic.way(robot);
    }

    /**
     * Returns the places that a robot has reserved for itself, the one where it is first.
     *
     * @param robot any
     * @return none if it does not drive to a place by this navigator
     */
    public List<Pose> reserved(MajicBot robot) {
        return traffic.reserved(robot);
    }

    /**
     * Returns why a robot stands on its way.
     *
     * @param robot any
     * @return a part of a sentence such as {@code robot 2 (Pioneer) stands in the way}; empty while it drives, and if
     *     it does not drive to a place by this navigator
     */
    public Optional<String> waits(MajicBot robot) {
        return traffic.waits(robot);
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

    TeamTraffic traffic() {
        return traffic;
    }

    boolean hasMap() {
        return map.get().isPresent();
    }

    /** Returns the other robots whose places are known. */
    List<MajicBot> others(MajicBot robot) {
        return robots.stream()
                .filter(other -> other != robot
                        && other.isConnected()
                        && other.uncertainty().isKnown())
                .toList();
    }

    /**
     * Returns what a robot has measured without what it has seen of the other robots: they are not on the map, and one
     * that drives ahead makes the walls of a corridor look as if they moved.
     */
    RangeScan withoutOthers(MajicBot robot, RangeScan scan) {
        Pose here = robot.odometryOrigin().plus(scan.odometry());
        List<FreeSpace.Disc> others = discs(robot).stream()
                .map(disc -> {
                    Pose seen = new Pose(disc.xMm(), disc.yMm(), 0).seenFrom(here);
                    return new FreeSpace.Disc(seen.xMm(), seen.yMm(), disc.radiusMm() + HULL_MM);
                })
                .toList();
        if (others.isEmpty()) {
            return scan;
        }
        float[] ranges = new float[scan.size()];
        for (int beam = 0; beam < ranges.length; beam++) {
            float range = scan.rangeMm(beam);
            ranges[beam] = range;
            if (Float.isFinite(range)) {
                Pose echo = scan.sensor().beams().get(beam).mount().after(range, 0);
                if (others.stream().anyMatch(other -> other.distanceMm(echo.xMm(), echo.yMm()) < 0)) {
                    ranges[beam] = Float.NaN;
                }
            }
        }
        return new RangeScan(scan.sensor(), scan.timeS(), scan.odometry(), ranges);
    }

    /** Returns where the other robots are whose places are known. */
    List<FreeSpace.Disc> discs(MajicBot robot) {
        return others(robot).stream()
                .map(other -> {
                    Pose there = other.state().pose();
                    return new FreeSpace.Disc(
                            there.xMm(), there.yMm(), other.profile().bodyMm());
                })
                .toList();
    }

    /** Returns the distances from the obstacles of the map, or of an empty plain around a way. */
    ObstacleDistance distances(MajicBot robot, Destination destination) {
        return distances(robot).orElseGet(() -> plain(robot, destination));
    }

    /** Returns the distances from the obstacles of the map; empty without one. */
    Optional<ObstacleDistance> distances(MajicBot robot) {
        return map.get().map(now -> distances(now, robot));
    }

    private synchronized ObstacleDistance distances(NavigationMap now, MajicBot robot) {
        ObstacleDistance before = distances;
        if (before != null && (measured == now || robot.time().secondsSince(measuredNanos) < MAP_S)) {
            return before;
        }
        ObstacleDistance made = new ObstacleDistance(now);
        measured = now;
        measuredNanos = robot.time().nanos();
        distances = made;
        return made;
    }

    private static ObstacleDistance plain(MajicBot robot, Destination destination) {
        Pose from = robot.state().pose();
        Pose to = destination.pose();
        if (from.distanceMm(to) > FARTHEST_WITHOUT_MAP_MM) {
            throw new BotException("goto " + destination + ": farther than 100 m, and there is no map");
        }
        double beside = BESIDE_MM + FreeSpace.MARGIN_MM + robot.profile().bodyMm();
        double left = Math.min(from.xMm(), to.xMm()) - beside;
        double low = Math.min(from.yMm(), to.yMm()) - beside;
        int width = (int) ((Math.abs(from.xMm() - to.xMm()) + 2 * beside) / CELL_WITHOUT_MAP_MM);
        int height = (int) ((Math.abs(from.yMm() - to.yMm()) + 2 * beside) / CELL_WITHOUT_MAP_MM);
        return new ObstacleDistance(NavigationMap.of(
                OccupancyGrid.of(new Pose(left, low, 0), CELL_WITHOUT_MAP_MM, width, height, (column, row) -> 0.02)));
    }
}
