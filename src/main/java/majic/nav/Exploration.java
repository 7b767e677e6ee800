package majic.nav;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import majic.bot.Course;
import majic.bot.MajicBot;
import majic.bot.MotionFailed;
import majic.bot.Pose;
import majic.bot.Value;
import majic.nav.grid.OccupancyGrid;
import majic.nav.path.FreeSpace;
import majic.nav.path.ObstacleDistance;
import majic.nav.path.PathPlanner;
import majic.nav.path.Way;
import org.jspecify.annotations.Nullable;

/**
 * One robot that explores: it drives to the nearest frontier of the map that it builds, until it can reach none
 * (Yamauchi 1997). A frontier that is seen from afar is left, and one that another robot drives to is left to that
 * robot. Made when the motion begins, and closed when it has ended.
 */
final class Exploration implements Course, AutoCloseable {
    /** The robot drives as near to a frontier, and looks at it from there. */
    private static final double VIEW_MM = 600;

    /** A frontier is the same one within this distance. */
    private static final double SAME_MM = 300;

    /** The heading at the goal is that to what is so far behind the frontier. */
    private static final double BEHIND_MM = 500;

    /** The map has what a stationary robot sees after this time, seconds. */
    private static final double LOOK_S = 3;

    private static final double FIRST_MAP_S = 10;

    /** Longest age of a reading by which a robot drives, seconds. */
    private static final double OLDEST_S = 1;

    private static final double MM2_PER_M2 = 1e6;

    private final MajicBot robot;
    private final Navigator navigator;
    private final BooleanSupplier builds;
    private final double begunS;

    /** Frontiers that showed nothing new, or could not be reached. */
    private final List<Pose> refused = new ArrayList<>();

    private @Nullable Known newest;
    private @Nullable Goal goal;
    private int explored;

    /** Since when the robot only waits for the map; negative if it does not. */
    private double waitsSinceS = -1;

    private boolean changed;

    /** Whether frontiers that were refused are tried for the second time, since no others are left. */
    private boolean secondTime;

    /** The map as it was last looked at. */
    private record Known(ObstacleDistance map, Frontiers frontiers) {}

    /** The frontier that the robot drives to. */
    private record Goal(Pose frontier, GoalCourse course) {}

    /**
     * An exploration from now on.
     *
     * @param builds whether the robot builds the map
     */
    Exploration(MajicBot robot, Navigator navigator, BooleanSupplier builds) {
        this.robot = robot;
        this.navigator = navigator;
        this.builds = builds;
        this.begunS = now();
    }

    private double now() {
        return robot.time().nanos() / 1e9;
    }

    @Override
    public void close() {
        leave();
    }

    private void leave() {
        Goal left = goal;
        if (left != null) {
            left.course().close();
            navigator.giveUpFrontier(robot);
        }
        goal = null;
        waitsSinceS = -1;
    }

    @Override
    public Value amount() {
        Known known = newest;
        String text = explored + (explored == 1 ? " frontier" : " frontiers");
        if (known == null) {
            return Value.text(text);
        }
        OccupancyGrid grid = known.map().grid();
        double area = grid.count(OccupancyGrid.State.FREE) * grid.cellMm() * grid.cellMm() / MM2_PER_M2;
        return Value.text(String.format(Locale.ROOT, "%s, %.0f m²", text, area));
    }

    @Override
    public Step next() {
        if (!builds.getAsBoolean()) {
            throw new MotionFailed("it builds the map no longer");
        }
        Optional<ObstacleDistance> map = navigator.space().distances(robot);
        if (map.isEmpty()) {
            if (now() - begunS > FIRST_MAP_S) {
                throw new MotionFailed("its scans gave no map for " + Math.round(FIRST_MAP_S) + " s");
            }
            return Drive.STAND;
        }
        if (!robot.uncertainty().isKnown()) {
            throw new MotionFailed("its place on the map is not known at present");
        }
        if (robot.time().secondsSince(robot.state().atNanos()) > OLDEST_S) {
            throw new MotionFailed("no report of the robot for 1 s");
        }
        Known known = look(map.get());
        Goal present = goal;
        if (present != null && known.frontiers().isNear(present.frontier(), SAME_MM)) {
            return follow(present);
        }
        if (present != null) {
            explored++;
            leave();
        }
        return choose(known);
    }

    /** Finds the frontiers again if the map has changed. */
    private Known look(ObstacleDistance map) {
        Known before = newest;
        if (before != null && before.map() == map) {
            return before;
        }
        Known now = new Known(map, new Frontiers(map.grid(), 2 * robot.profile().bodyMm()));
        newest = now;
        changed = true;
        return now;
    }

    private Step follow(Goal present) {
        try {
            if (waitsSinceS < 0) {
                Step step = present.course().next();
                if (!(step instanceof Arrived)) {
                    return step;
                }
                waitsSinceS = now();
            }
            if (now() - waitsSinceS < LOOK_S) {
                return Drive.STAND;
            }
        } catch (NoWay e) {
            // The frontier is refused as one that showed nothing new.
        }
        refused.add(present.frontier());
        leave();
        changed = true;
        return Drive.STAND;
    }

    private boolean isWanted(Pose frontier) {
        return refused.stream().noneMatch(one -> one.distanceMm(frontier) < VIEW_MM);
    }

    /** Begins to drive to the nearest frontier; stands while the map may still show one, or another robot has it. */
    private Step choose(Known known) {
        boolean waited = waitsSinceS >= 0 && now() - waitsSinceS > LOOK_S;
        if (!changed && !waited) {
            return Drive.STAND;
        }
        changed = false;
        goal = nearest(known, frontier -> isWanted(frontier) && !navigator.isTaken(robot, frontier))
                .orElse(null);
        if (goal != null) {
            waitsSinceS = -1;
        } else if (waitsSinceS < 0) {
            waitsSinceS = now();
        } else if (waited && !isReachable(known)) {
            return atLast();
        }
        return Drive.STAND;
    }

    /** Ends, or tries again what was refused: the map has grown since, and what stood in the way may have gone. */
    private Step atLast() {
        if (secondTime || refused.isEmpty()) {
            return new Arrived(amount());
        }
        secondTime = true;
        refused.clear();
        changed = true;
        return Drive.STAND;
    }

    private boolean isReachable(Known known) {
        return way(known, known.frontiers().views(this::isWanted, VIEW_MM)).isPresent();
    }

    private FreeSpace space(Known known) {
        List<FreeSpace.Disc> standing = navigator.space().others(robot).stream()
                .filter(other -> !navigator.space().traffic().isUnderWay(other))
                .map(other -> new FreeSpace.Disc(
                        other.state().pose().xMm(),
                        other.state().pose().yMm(),
                        other.profile().bodyMm()))
                .toList();
        return new FreeSpace(
                known.map(), robot.profile().bodyMm(), standing, robot.fence().orElse(null));
    }

    private Optional<Way> way(Known known, Frontiers.Views views) {
        return new PathPlanner(space(known))
                .planToNearest(
                        robot.state().pose(),
                        Double.POSITIVE_INFINITY,
                        place -> views.from(place).isPresent());
    }

    private Optional<Goal> nearest(Known known, Predicate<Pose> wanted) {
        Frontiers.Views views = known.frontiers().views(wanted, VIEW_MM);
        Optional<Pose> end = way(known, views).map(Way::end);
        Optional<Pose> frontier = end.flatMap(views::from);
        if (end.isEmpty() || frontier.isEmpty() || !navigator.takeFrontier(robot, frontier.get())) {
            return Optional.empty();
        }
        Pose behind = frontier.get().after(BEHIND_MM, 0);
        double heading = Math.toDegrees(Math.atan2(
                behind.yMm() - end.get().yMm(), behind.xMm() - end.get().xMm()));
        Pose place = new Pose(end.get().xMm(), end.get().yMm(), heading);
        return Optional.of(
                new Goal(frontier.get(), new GoalCourse(robot, new Destination(place, true), navigator.space())));
    }
}
