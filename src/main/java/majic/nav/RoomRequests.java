package majic.nav;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.DoubleStream;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.nav.path.FreeSpace;
import majic.nav.path.FreeSpace.Disc;
import majic.nav.path.PathPlanner;
import majic.nav.path.Way;
import majic.time.WaitPolicy;

/**
 * Asks a robot that stands in the way of one under way to drive aside, if its parameter {@code giveWay} is on. Used by
 * the thread that drives the robot under way.
 */
final class RoomRequests {
    private static final String GIVE_WAY = "giveWay";

    /** After a request none is made for so long. */
    private static final double AGAIN_S = 10;

    /** How far a place aside may be, and what has to be left beside the robot and the way there. */
    private static final double FARTHEST_MM = 8000;

    private static final double ROOM_MM = 80;
    private static final double BESIDE_WAY_MM = 100;
    private static final double STEP_MM = 100;

    private static final String NO_PLACE = "there is no place where it leaves room";
    private static final String NOT_MADE = "it was asked to make room and did not";

    private final LocalSpace local;
    private final Destination destination;
    private final GiveWay.Requests requests;
    private final TeamSpace team;
    private final MajicBot robot;
    private double askedS = Double.NEGATIVE_INFINITY;
    private String without = "";

    /** The robots that were asked and have not driven aside, because they were stopped for instance. */
    private final Set<MajicBot> failed = ConcurrentHashMap.newKeySet();

    /** No request is made yet. */
    RoomRequests(MajicBot robot, Destination destination, LocalSpace local, TeamSpace team) {
        this.robot = robot;
        this.destination = destination;
        this.local = local;
        this.team = team;
        this.requests = team.giveWay().begin(robot);
    }

    private double now() {
        return robot.time().nanos() / 1e9;
    }

    /**
     * Asks a robot to make room, unless one was asked lately, or this one was asked and did not make room.
     *
     * @param standing what stands in the way from {@code here} to the destination
     * @return why a request was of no use; empty if it may be, or none can be made
     */
    String ask(MajicBot standing, Pose here) {
        if (failed.contains(standing)) {
            return NOT_MADE;
        }
        if (now() - askedS > AGAIN_S && givesWay(standing)) {
            without = "";
            requests.ask(standing, () -> aside(standing, here), () -> failed.add(standing));
        }
        return without;
    }

    private boolean givesWay(MajicBot standing) {
        return WaitPolicy.without(() -> !standing.state().moving()
                && !team.traffic().isUnderWay(standing)
                && standing.reading(GIVE_WAY).value().isYes());
    }

    /** Finds the nearest place where the standing robot leaves the way free that this one would take without it. */
    private Optional<Destination> aside(MajicBot standing, Pose here) {
        askedS = now();
        Optional<Destination> found = new PathPlanner(without(standing, local.beside()))
                .plan(here, destination.pose())
                .flatMap(way -> aside(standing, here, way));
        without = found.isPresent() ? "" : NO_PLACE;
        return found;
    }

    private Optional<Destination> aside(MajicBot standing, Pose here, Way way) {
        Pose there = standing.state().pose();
        double apart = TeamTraffic.apartMm(robot, standing) + BESIDE_WAY_MM;
        List<Pose> kept = DoubleStream.iterate(0, mm -> mm < way.lengthMm() + STEP_MM, mm -> mm + STEP_MM)
                .mapToObj(way::at)
                .filter(place -> place.distanceMm(there) < FARTHEST_MM + apart)
                .toList();
        FreeSpace space = spaceOf(standing, here);
        return new PathPlanner(space)
                .planToNearest(
                        there,
                        FARTHEST_MM,
                        place -> space.mm(place.xMm(), place.yMm()) > ROOM_MM
                                && kept.stream().allMatch(point -> point.distanceMm(place) >= apart))
                .map(Way::end)
                .map(end -> new Destination(Math.rint(end.xMm()), Math.rint(end.yMm())));
    }

    /** Where the standing robot fits, by what this one knows. */
    private FreeSpace spaceOf(MajicBot standing, Pose here) {
        List<Disc> things =
                new ArrayList<>(without(standing, local.besideTraffic()).things());
        things.add(new Disc(here.xMm(), here.yMm(), robot.profile().bodyMm()));
        return new FreeSpace(
                local.map(),
                standing.profile().bodyMm(),
                things,
                standing.fence().orElse(null));
    }

    /** Returns a space without one of the robots in it. */
    static FreeSpace without(MajicBot other, FreeSpace space) {
        List<Disc> things = new ArrayList<>(space.things());
        Pose there = other.state().pose();
        things.removeIf(disc -> disc.xMm() == there.xMm() && disc.yMm() == there.yMm());
        return space.with(things);
    }
}
