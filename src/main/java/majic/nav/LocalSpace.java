package majic.nav;

import java.util.ArrayList;
import java.util.List;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.nav.path.FreeSpace;
import majic.nav.path.FreeSpace.Disc;
import majic.nav.path.ObstacleDistance;

/**
 * Where one robot on its way fits at present: the obstacles of the map, what its sensors have seen lately, and the
 * other robots. Used by the thread that drives the robot.
 */
final class LocalSpace {
    /** Echoes as near to a wall of the map are of that wall. */
    private static final double WALL_MM = 150;

    private final MajicBot robot;
    private final Destination destination;
    private final TeamSpace team;
    private final SeenObstacles seen;
    private final boolean hasRanges;
    private final boolean looksAhead;

    /** The other robots at the present decision; also read by the thread of the scans. */
    private volatile List<Disc> others;

    private volatile ObstacleDistance map;
    private boolean onMap;

    LocalSpace(MajicBot robot, Destination destination, TeamSpace team) {
        this.robot = robot;
        this.destination = destination;
        this.team = team;
        this.hasRanges = !robot.rangeSensors().isEmpty();
        this.looksAhead = SeenObstacles.looksAhead(robot);
        this.others = team.discs(robot);
        this.onMap = team.hasMap();
        this.map = team.distances(robot, destination);
        this.seen = new SeenObstacles(robot, this::isKnown);
    }

    /** Begins to take the scans of the robot, until {@link #close}. */
    void open() {
        if (hasRanges) {
            robot.addScanListener(seen);
        }
    }

    void close() {
        robot.removeScanListener(seen);
    }

    private boolean isKnown(double xMm, double yMm) {
        return map.mm(xMm, yMm) < WALL_MM
                || others.stream().anyMatch(other -> other.distanceMm(xMm, yMm) < TeamSpace.HULL_MM);
    }

    /** Looks where the other robots are now. */
    void lookAtOthers() {
        others = team.discs(robot);
    }

    /** Takes the map as it is now. The plain of a robot without a map stays as it is until there is one. */
    void lookAtMap() {
        boolean hasMap = team.hasMap();
        if (hasMap || onMap) {
            map = team.distances(robot, destination);
            onMap = hasMap;
        }
    }

    /** Takes what a robot without described range sensors measures ahead of it, if it measures that. */
    void lookAhead(Pose here) {
        if (looksAhead) {
            seen.lookAhead(here.seenFrom(robot.odometryOrigin()));
        }
    }

    /** Whether its sensors see obstacles, but have reported nothing for a time. */
    boolean isBlind(double seconds) {
        return (hasRanges || looksAhead) && seen.ageS() > seconds;
    }

    /** Whether its sensors have shown anything yet. */
    boolean hasScanned() {
        return seen.hasScanned();
    }

    ObstacleDistance map() {
        return map;
    }

    /** Returns where the robot fits on the map alone. */
    FreeSpace onMapOnly() {
        return with(List.of());
    }

    /** Returns where it fits beside what is not on the map and stays: what it has seen, and the robots that stand. */
    FreeSpace beside() {
        return with(things(false, false));
    }

    /** Returns where it fits as {@link #beside} does, also beside the robots that are under way. */
    FreeSpace besideTraffic() {
        return with(things(true, false));
    }

    /**
     * Returns where it fits now, beside all robots and all that its sensors see, also what the map has: seen from the
     * robot it is where it is, however wrong the place of the robot is.
     */
    FreeSpace now() {
        return with(things(true, true));
    }

    /**
     * How near to the middle of the robot its sensors have seen something that is not on the map and no robot of the
     * team, mm; infinite if nothing is there.
     */
    double nearestUnknownMm(Pose here) {
        Pose origin = robot.odometryOrigin();
        double nearest = Double.POSITIVE_INFINITY;
        for (SeenObstacles.Point point : seen.points()) {
            Pose place = origin.plus(new Pose(point.xMm(), point.yMm(), 0));
            if (!point.known() && !isKnown(place.xMm(), place.yMm())) {
                nearest = Math.min(nearest, place.distanceMm(here));
            }
        }
        return nearest;
    }

    private FreeSpace with(List<Disc> things) {
        return new FreeSpace(
                map, robot.profile().bodyMm(), things, robot.fence().orElse(null));
    }

    private List<Disc> things(boolean withTraffic, boolean withKnown) {
        List<Disc> things = new ArrayList<>();
        Pose origin = robot.odometryOrigin();
        for (SeenObstacles.Point point : seen.points()) {
            Pose place = origin.plus(new Pose(point.xMm(), point.yMm(), 0));
            if (point.known() ? withKnown : !isKnown(place.xMm(), place.yMm())) {
                things.add(new Disc(place.xMm(), place.yMm(), 0));
            }
        }
        for (MajicBot other : team.others(robot)) {
            if (withTraffic || !team.traffic().isUnderWay(other)) {
                Pose there = other.state().pose();
                double apart = withKnown ? 0 : 2 * FreeSpace.MARGIN_MM;
                things.add(new Disc(there.xMm(), there.yMm(), other.profile().bodyMm() + apart));
            }
        }
        return things;
    }
}
