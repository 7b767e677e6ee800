package majic.nav;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.OccupancyGrid;
import majic.nav.path.FreeSpace;
import majic.nav.path.ObstacleDistance;
import org.jspecify.annotations.Nullable;

/** What the robots of a team drive by: the map, the places of the others, and their traffic. Thread-safe. */
final class TeamSpace {
    /** Without a map, what lies as far beside the way counts as room to drive around something, mm. */
    private static final double BESIDE_MM = 5000;

    /** An echo as near to the hull of another robot is of that robot. */
    static final double HULL_MM = 200;

    private static final double FARTHEST_WITHOUT_MAP_MM = 100_000;
    private static final double CELL_WITHOUT_MAP_MM = 100;

    /** A map that grows is looked at as often, seconds. */
    private static final double MAP_S = 2;

    private final Supplier<Optional<NavigationMap>> map;
    private final Set<MajicBot> robots = ConcurrentHashMap.newKeySet();
    private final TeamTraffic traffic = new TeamTraffic();
    private volatile GiveWay giveWay = GiveWay.NEVER;
    private @Nullable NavigationMap measured;
    private @Nullable ObstacleDistance distances;
    private long measuredNanos;

    /** A team without robots; the map is asked for again and again. */
    TeamSpace(Supplier<Optional<NavigationMap>> map) {
        this.map = map;
    }

    void add(MajicBot robot) {
        robots.add(robot);
    }

    void remove(MajicBot robot) {
        robots.remove(robot);
    }

    void useGiveWay(GiveWay asks) {
        giveWay = asks;
    }

    GiveWay giveWay() {
        return giveWay;
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
