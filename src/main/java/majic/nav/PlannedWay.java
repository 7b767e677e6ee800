package majic.nav;

import java.util.Locale;
import java.util.Optional;
import majic.bot.Fence;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.nav.path.FreeSpace;
import majic.nav.path.ObstacleDistance;
import majic.nav.path.PathPlanner;
import majic.nav.path.Way;
import org.jspecify.annotations.Nullable;

/**
 * The way of one robot to its destination, or for a time to a place aside of it. Is planned anew if it is blocked or
 * left, and every 5 s. Used by the thread that drives the robot.
 */
final class PlannedWay {
    /** The way is planned anew after this time, if it is blocked or left, and whatever happens. */
    private static final double BLOCKED_PLAN_S = 0.5;

    private static final double PLAN_S = 5;
    private static final double LEFT_WAY_MM = 300;

    /** How far along the way things that were seen make a new plan. */
    private static final double LOOK_MM = 3000;

    /** So often another way around other robots is tried, and for half of that it is kept. */
    private static final double AROUND_S = 20;

    private static final double LONGEST_AROUND = 1.3;

    private final LocalSpace local;
    private final Destination destination;
    private final TeamSpace team;
    private final TeamTraffic.Vehicle vehicle;
    private @Nullable Way way;
    private @Nullable Pose aside;
    private double plannedS = Double.NEGATIVE_INFINITY;
    private double aroundS = Double.NEGATIVE_INFINITY;

    /** What came of an attempt to plan. */
    enum Planning {
        /** The way stays as it is. */
        NOT_DUE,
        FOUND,
        NO_WAY
    }

    PlannedWay(LocalSpace local, Destination destination, TeamSpace team, TeamTraffic.Vehicle vehicle) {
        this.local = local;
        this.destination = destination;
        this.team = team;
        this.vehicle = vehicle;
    }

    private double now() {
        return vehicle.robot().time().nanos() / 1e9;
    }

    /** Returns the way from its beginning. */
    Optional<Way> way() {
        return Optional.ofNullable(way);
    }

    /** Returns the place aside to which it leads; empty if it leads to the destination. */
    Optional<Pose> aside() {
        return Optional.ofNullable(aside);
    }

    /** Takes a way to a place aside, until {@link #leadToDestination}. */
    void leadAside(Way there) {
        way = there;
        aside = there.end();
        plannedS = now();
    }

    /** Has no way until one to the destination is planned. */
    void leadToDestination() {
        way = null;
        aside = null;
        plannedS = Double.NEGATIVE_INFINITY;
    }

    /** Looks for a way around the robots under way, unless it did so lately. */
    void tryAround() {
        if (now() - aroundS > AROUND_S) {
            aroundS = now();
            plannedS = Double.NEGATIVE_INFINITY;
        }
    }

    /** Plans the way if that is due. */
    Planning plan(Pose here, FreeSpace space) {
        if (!isDue(here, space)) {
            return Planning.NOT_DUE;
        }
        plannedS = now();
        Way old = way;
        Pose to = aside == null ? destination.pose() : aside;
        boolean around = now() - aroundS < AROUND_S / 2;
        Optional<Way> found = planner(around ? local.besideTraffic() : space).plan(here, to);
        if (around && (found.isEmpty() || found.get().lengthMm() > LONGEST_AROUND * restMm(old, here))) {
            found = planner(space).plan(here, to);
        }
        way = found.orElse(null);
        return found.isPresent() ? Planning.FOUND : Planning.NO_WAY;
    }

    private boolean isDue(Pose here, FreeSpace space) {
        Way old = way;
        double age = now() - plannedS;
        if (old == null) {
            return age > BLOCKED_PLAN_S;
        }
        boolean isAwaited = age <= Waiting.LONGEST_BLOCKED_S && team.traffic().isRoomMadeFor(vehicle);
        boolean isKept = isAwaited || aside != null && age <= PLAN_S;
        return !isKept
                && (age > PLAN_S || age > BLOCKED_PLAN_S && (isBlocked(old.from(here), space) || isLeft(old, here)));
    }

    private PathPlanner planner(FreeSpace space) {
        return new PathPlanner(space, team.traffic().isBusy());
    }

    private static double restMm(@Nullable Way way, Pose here) {
        return way == null ? Double.POSITIVE_INFINITY : way.from(here).lengthMm() + LEFT_WAY_MM;
    }

    private static boolean isLeft(Way old, Pose here) {
        return old.from(here).points().get(0).distanceMm(here) > LEFT_WAY_MM;
    }

    private static boolean isBlocked(Way rest, FreeSpace space) {
        double end = Math.min(LOOK_MM, rest.lengthMm());
        for (double mm = FreeSpace.MARGIN_MM; mm < end; mm += 2 * FreeSpace.MARGIN_MM) {
            Pose at = rest.at(mm);
            if (space.mm(at.xMm(), at.yMm()) < 0) {
                return true;
            }
        }
        return false;
    }

    /**
     * Finds out why there is no way to the destination.
     *
     * @return the robot that stands in the way; empty if it is something that the sensors see
     * @throws NoWay if the map shows none
     */
    Optional<MajicBot> obstacle(Pose here, FreeSpace space) {
        refuseWithoutWayOnMap(here);
        Pose to = destination.pose();
        for (MajicBot other : team.others(vehicle.robot())) {
            FreeSpace without = RoomRequests.without(other, space);
            if (without.things().size() < space.things().size()
                    && new PathPlanner(without).plan(here, to).isPresent()) {
                return Optional.of(other);
            }
        }
        return Optional.empty();
    }

    private void refuseWithoutWayOnMap(Pose here) {
        ObstacleDistance map = local.map();
        double bodyMm = vehicle.robot().profile().bodyMm();
        Pose to = destination.pose();
        double free = map.mm(to.xMm(), to.yMm());
        if (free == 0) {
            throw noWay("it is inside a wall");
        }
        if (free < bodyMm) {
            throw noWay(String.format(
                    Locale.ROOT,
                    "a wall or forbidden line is %.0f mm from it, and the robot has a radius of %.0f mm",
                    free,
                    bodyMm));
        }
        if (!map.isKnown(to.xMm(), to.yMm())) {
            throw noWay("nothing is known of that place; the map has to be larger");
        }
        FreeSpace fenced = local.onMapOnly();
        if (new PathPlanner(fenced).plan(here, to).isPresent()) {
            return;
        }
        Fence fence = fenced.fence();
        if (fence != null && new PathPlanner(fenced.unfenced()).plan(here, to).isPresent()) {
            throw noWay("every way leaves the fence of " + fence.radius() + "; \"set fence\" sets a larger one");
        }
        throw noWay("walls, or what is unknown, close every way that is as wide as the robot ("
                + Math.round(2 * (bodyMm + FreeSpace.MARGIN_MM)) + " mm)");
    }

    private NoWay noWay(String why) {
        return new NoWay("no way to " + destination + ": " + why);
    }
}
