package majic.nav;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.nav.path.FreeSpace;
import majic.nav.path.PathPlanner;
import majic.nav.path.Way;
import org.jspecify.annotations.Nullable;

/**
 * Makes room for robots that go first: takes a robot on its way to a place aside of theirs, and back to its own way
 * when they have passed. Used by the thread that drives the robot.
 */
final class Yielding {
    /** How far along the way of the other robot to look, and how far a place aside may be. */
    private static final double MAKE_ROOM_MM = 8000;

    /** For how long the other robot has to have waited. */
    private static final double MAKE_ROOM_S = 1;

    /** What has to be left beside a robot that makes room, and how long it does not do so again. */
    private static final double ASIDE_ROOM_MM = 80;

    private static final double AGAIN_ASIDE_S = 5;

    /** How often it looks whether the other one has passed. */
    private static final double LOOK_S = 0.5;

    private static final double STEP_MM = 100;

    private final MajicBot robot;
    private final LocalSpace local;
    private final PlannedWay planned;
    private final Destination destination;
    private final TeamTraffic traffic;
    private final TeamTraffic.Vehicle vehicle;
    private TeamTraffic.@Nullable Vehicle roomFor;
    private double asideS = Double.NEGATIVE_INFINITY;
    private double lookedS = Double.NEGATIVE_INFINITY;

    /**
     * No room is made yet.
     *
     * @param planned the way of the robot, which leads aside meanwhile
     */
    Yielding(
            LocalSpace local,
            PlannedWay planned,
            Destination destination,
            TeamTraffic traffic,
            TeamTraffic.Vehicle vehicle) {
        this.robot = vehicle.robot();
        this.local = local;
        this.planned = planned;
        this.destination = destination;
        this.traffic = traffic;
        this.vehicle = vehicle;
    }

    private double now() {
        return robot.time().nanos() / 1e9;
    }

    /** Whether the robot drives to a place aside, or stands there. */
    boolean isActive() {
        return planned.aside().isPresent();
    }

    /** Takes a way aside if a robot that goes first waits, and needs the place where this one is. */
    void makeRoom(Pose here, FreeSpace space) {
        if (isActive() || now() - asideS < AGAIN_ASIDE_S) {
            return;
        }
        TeamTraffic.Vehicle first =
                traffic.toMakeRoomFor(vehicle, MAKE_ROOM_MM, MAKE_ROOM_S).orElse(null);
        if (first == null) {
            return;
        }
        Predicate<Pose> isAside = place -> traffic.isAside(first, robot, place, MAKE_ROOM_MM)
                && space.mm(place.xMm(), place.yMm()) > ASIDE_ROOM_MM
                && traffic.isFree(vehicle, place);
        Optional<Way> found = new PathPlanner(local.besideTraffic())
                .planToNearest(here, MAKE_ROOM_MM, isAside)
                .or(() -> new PathPlanner(space).planToNearest(here, MAKE_ROOM_MM, isAside));
        asideS = now();
        found.ifPresent(there -> {
            planned.leadAside(there);
            roomFor = first;
            traffic.standIn(vehicle, first);
        });
    }

    /** Keeps the place aside until the other robot has passed; returns that robot, or null if it is not known. */
    @Nullable
    MajicBot standAside(Pose here) {
        traffic.reserve(vehicle, new Way(List.of(here)), 0);
        TeamTraffic.Vehicle other = roomFor;
        if (now() - lookedS >= LOOK_S) {
            lookedS = now();
            if (other == null || hasPassed(other, here) || now() - asideS > Waiting.LONGEST_BLOCKED_S) {
                end();
            }
        }
        return other == null ? null : other.robot();
    }

    private boolean hasPassed(TeamTraffic.Vehicle other, Pose here) {
        return !traffic.isUnderWay(other)
                || traffic.leadsThrough(other, robot, here, MAKE_ROOM_MM)
                || !crosses(other, here);
    }

    /** Ends making room; the robot takes its own way again. */
    void end() {
        roomFor = null;
        asideS = now();
        planned.leadToDestination();
        traffic.takeBack(vehicle);
    }

    /** Whether the rest of another one's way still leads along the way that this robot would take. */
    private boolean crosses(TeamTraffic.Vehicle other, Pose here) {
        Optional<Way> own = new PathPlanner(local.beside()).plan(here, destination.pose());
        if (own.isEmpty()) {
            return false;
        }
        for (double mm = 0; mm < Math.min(MAKE_ROOM_MM / 4, own.get().lengthMm()); mm += STEP_MM) {
            if (traffic.leadsThrough(other, robot, own.get().at(mm), MAKE_ROOM_MM)) {
                return true;
            }
        }
        return false;
    }
}
