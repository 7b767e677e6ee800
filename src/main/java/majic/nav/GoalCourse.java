package majic.nav;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import majic.bot.Course;
import majic.bot.DriveGuard.Room;
import majic.bot.MajicBot;
import majic.bot.MotionFailed;
import majic.bot.Pose;
import majic.bot.Value;
import majic.nav.path.FreeSpace;
import majic.nav.path.FreeSpace.Disc;
import majic.nav.path.ObstacleDistance;
import majic.nav.path.PathPlanner;
import majic.nav.path.Way;
import org.jspecify.annotations.Nullable;

/**
 * One robot on its way to a place: plans a way, follows it by driving towards a point ahead on it (pure pursuit;
 * Coulter 1992), slows down in front of what is in the way and plans again. Made when the motion begins, and closed
 * when it has ended.
 */
final class GoalCourse implements Course, AutoCloseable {
    /** Longest age of a reading by which a robot drives, seconds. */
    private static final double OLDEST_S = 1;

    private static final double ARRIVED_MM = 12;
    private static final double NEARLY_MM = 30;
    private static final double ARRIVED_DEG = 2;
    private static final int MOST_TURNS_AT_END = 3;

    /** A robot turns on the spot if the way bends by more. */
    private static final double ON_THE_SPOT_DEG = 50;

    private static final double LEAST_TURN_DEG = 5;

    /** How fast it gets faster. */
    private static final double ACCELERATION_MM_PER_S2 = 250;

    private static final double SLOW_MM_PER_S = 25;

    /** How the speed falls at the end: as many mm/s for each mm. */
    private static final double END_PER_S = 1.2;

    /** The point ahead on the way, in time and at least. */
    private static final double AHEAD_S = 0.9;

    private static final double AHEAD_MM = 250;

    /** The way is planned anew after this time, if it is blocked or left, and whatever happens. */
    private static final double BLOCKED_PLAN_S = 0.5;

    private static final double PLAN_S = 5;
    private static final double LEFT_WAY_MM = 300;

    /** How far along the way things that were seen make a new plan. */
    private static final double LOOK_MM = 3000;

    /** How far an arc is looked along. */
    private static final double LOOK_ARC_MM = 1200;

    /** Echoes as near to a wall of the map are of that wall. */
    private static final double WALL_MM = 150;

    /** How long something may stand in the way, and how long other robots may be waited for. */
    private static final double LONGEST_BLOCKED_S = 20;

    private static final double LONGEST_TRAFFIC_S = 180;
    private static final double PROGRESS_MM = 50;

    /** The straight pieces of a robot that estimates its place. */
    private static final double PIECE_MM = 400;

    private static final double LEAST_PIECE_MM = 40;
    private static final double PIECE_DEG = 4;
    private static final double LONGEST_WHOLE_S = 300;
    private static final double TIMES_USUAL = 10;

    /** Traffic: when another way is tried, and when room is made. */
    private static final double OTHER_WAY_S = 3;

    /** So often another way around other robots is tried, and for half of that it is kept. */
    private static final double AROUND_S = 20;

    private static final double LONGEST_AROUND = 1.3;

    private static final double MAKE_ROOM_S = 1;
    private static final double MAKE_ROOM_MM = 8000;

    /** What has to be left beside a robot that makes room, and how long it does not do so again. */
    private static final double ASIDE_ROOM_MM = 80;

    private static final double AGAIN_ASIDE_S = 5;

    /** How often it looks whether the other one has passed. */
    private static final double LOOK_S = 0.5;

    private final MajicBot robot;
    private final Destination destination;
    private final Navigator navigator;
    private final SeenObstacles seen;
    private final TeamTraffic.Vehicle vehicle;
    private final boolean hasRanges;
    private final boolean looksAhead;

    /** The other robots at the present decision; also read by the thread of the scans. */
    private volatile List<Disc> others;

    private final double bodyMm;
    private ObstacleDistance map;
    private boolean onMap;
    private @Nullable Way way;
    private double plannedS = Double.NEGATIVE_INFINITY;
    private double progressS;
    private final double begunS;
    private double longestWholeS = Double.POSITIVE_INFINITY;
    private double leastLeftMm = Double.POSITIVE_INFINITY;
    private double speed;
    private int turnsAtEnd;
    private String waits = "";
    private @Nullable MajicBot before;
    private double aroundS = Double.NEGATIVE_INFINITY;
    private TeamTraffic.@Nullable Vehicle roomFor;
    private @Nullable Pose aside;
    private double asideS = Double.NEGATIVE_INFINITY;
    private double lookedS = Double.NEGATIVE_INFINITY;

    /** The place cannot be reached at present, though the robot could drive. */
    static final class NoWay extends MotionFailed {
        private static final long serialVersionUID = 1;

        private NoWay(String message) {
            super(message);
        }
    }

    GoalCourse(MajicBot robot, Destination destination, Navigator navigator) {
        this.robot = robot;
        this.destination = destination;
        this.navigator = navigator;
        this.bodyMm = robot.profile().bodyMm();
        this.hasRanges = !robot.rangeSensors().isEmpty();
        this.looksAhead = SeenObstacles.looksAhead(robot);
        this.others = navigator.discs(robot);
        this.onMap = navigator.hasMap();
        this.map = navigator.distances(robot, destination);
        this.seen = new SeenObstacles(robot, this::isKnown);
        this.vehicle = navigator.traffic().begin(robot);
        this.progressS = now();
        this.begunS = progressS;
        if (hasRanges) {
            robot.addScanListener(seen);
        }
    }

    @Override
    public void close() {
        robot.removeScanListener(seen);
        navigator.traffic().end(vehicle);
    }

    private double now() {
        return robot.time().nanos() / 1e9;
    }

    private boolean isKnown(double xMm, double yMm) {
        return map.mm(xMm, yMm) < WALL_MM
                || others.stream().anyMatch(other -> other.distanceMm(xMm, yMm) < Navigator.HULL_MM);
    }

    @Override
    public Value amount() {
        return Navigator.place(robot);
    }

    @Override
    public Step next() {
        Step step = decide();
        navigator.traffic().explain(vehicle, step == Drive.STAND ? waits : "");
        return step;
    }

    private Step decide() {
        Pose here = robot.state().pose();
        others = navigator.discs(robot);
        refuseUncertain(here);
        look(here);
        if ((hasRanges || looksAhead) && seen.ageS() > OLDEST_S) {
            throw new MotionFailed("no reading of its range sensors for 1 s");
        }
        double left = here.distanceMm(destination.pose());
        if (left <= ARRIVED_MM || left <= NEARLY_MM && turnsAtEnd > 0) {
            return arrived(here);
        }
        lookAtMap();
        FreeSpace space = new FreeSpace(map, bodyMm, things(false, false));
        plan(here, space);
        return along(here, space, left);
    }

    /** The plain of a robot without a map stays as it is until there is one. */
    private void lookAtMap() {
        boolean hasMap = navigator.hasMap();
        if (hasMap || onMap) {
            map = navigator.distances(robot, destination);
            onMap = hasMap;
        }
    }

    private void refuseUncertain(Pose here) {
        if (robot.time().secondsSince(robot.state().atNanos()) > OLDEST_S) {
            throw new MotionFailed("no report of the robot for 1 s");
        }
        if (!navigator.hasMap()) {
            return;
        }
        if (!robot.uncertainty().isKnown()) {
            throw new MotionFailed("its place on the map is not known; \"set pose\" or \"localize\" places it");
        }
        double sigma = robot.uncertainty().sigmaMm();
        double free = map.mm(here.xMm(), here.yMm());
        if (sigma > Math.max(free, bodyMm)) {
            throw new MotionFailed(String.format(
                    Locale.ROOT,
                    "its place is uncertain by %.0f mm, and the nearest obstacle of the map is %.0f mm away;"
                            + " \"set pose\" places it",
                    sigma,
                    free));
        }
    }

    private Step arrived(Pose here) {
        double wrong = Pose.normalised(destination.pose().headingDeg() - here.headingDeg());
        if (!destination.withHeading() || Math.abs(wrong) < ARRIVED_DEG || turnsAtEnd >= MOST_TURNS_AT_END) {
            return speed > 0 ? stand() : new Arrived(amount());
        }
        if (speed > 0) {
            return stand();
        }
        turnsAtEnd++;
        return new Turn(wrong);
    }

    private Step stand() {
        speed = 0;
        return Drive.STAND;
    }

    /**
     * What is not on the map: what was seen, and the other robots.
     *
     * @param withTraffic also those that are under way
     * @param withKnown also what the map has: seen from here it is where it is, however wrong the place of this robot
     */
    private List<Disc> things(boolean withTraffic, boolean withKnown) {
        List<Disc> things = new ArrayList<>();
        Pose origin = robot.odometryOrigin();
        for (SeenObstacles.Point point : seen.points()) {
            Pose place = origin.plus(new Pose(point.xMm(), point.yMm(), 0));
            if (point.known() ? withKnown : !isKnown(place.xMm(), place.yMm())) {
                things.add(new Disc(place.xMm(), place.yMm(), 0));
            }
        }
        for (MajicBot other : navigator.others(robot)) {
            Pose there = other.state().pose();
            if (withTraffic || !navigator.traffic().isUnderWay(other)) {
                double apart = withKnown ? 0 : 2 * FreeSpace.MARGIN_MM;
                things.add(new Disc(there.xMm(), there.yMm(), other.profile().bodyMm() + apart));
            }
        }
        return things;
    }

    private void plan(Pose here, FreeSpace space) {
        Way old = way;
        double age = now() - plannedS;
        boolean due = age > PLAN_S
                || age > BLOCKED_PLAN_S && (old == null || isBlocked(old.from(here), space) || isLeft(old, here));
        boolean isAwaited =
                old != null && age <= LONGEST_BLOCKED_S && navigator.traffic().isRoomMadeFor(vehicle);
        if (!due || isAwaited || aside != null && old != null && age <= PLAN_S) {
            return;
        }
        plannedS = now();
        Pose to = aside == null ? destination.pose() : aside;
        boolean around = now() - aroundS < AROUND_S / 2;
        FreeSpace planned = around ? space.with(things(true, false)) : space;
        Optional<Way> found = planner(planned).plan(here, to);
        if (around && (found.isEmpty() || found.get().lengthMm() > LONGEST_AROUND * restMm(old, here))) {
            found = planner(space).plan(here, to);
        }
        if (found.isPresent()) {
            way = found.get();
            leastLeftMm = way.lengthMm() > leastLeftMm + LEFT_WAY_MM ? way.lengthMm() : leastLeftMm;
            if (longestWholeS == Double.POSITIVE_INFINITY) {
                longestWholeS = LONGEST_WHOLE_S + TIMES_USUAL * way.lengthMm() / cruise();
            }
        } else if (aside != null) {
            goOn();
        } else {
            way = null;
            holdOrFail(here, space);
        }
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

    /** Says why there is no way: fails at once if the map shows none, or waits for what may go away. */
    private void holdOrFail(Pose here, FreeSpace space) {
        Pose to = destination.pose();
        if (map.mm(to.xMm(), to.yMm()) < bodyMm) {
            throw noWay(
                    map.mm(to.xMm(), to.yMm()) == 0
                            ? "it is inside a wall"
                            : String.format(
                                    Locale.ROOT,
                                    "a wall or forbidden line is %.0f mm from it, and the robot has a radius of %.0f mm",
                                    map.mm(to.xMm(), to.yMm()),
                                    bodyMm));
        }
        if (!map.isKnown(to.xMm(), to.yMm())) {
            throw noWay("nothing is known of that place; the map has to be larger");
        }
        if (new PathPlanner(space.with(List.of())).plan(here, to).isEmpty()) {
            throw noWay("walls, or what is unknown, close every way that is as wide as the robot ("
                    + Math.round(2 * (bodyMm + FreeSpace.MARGIN_MM)) + " mm)");
        }
        before = null;
        for (MajicBot other : navigator.others(robot)) {
            List<Disc> without = new ArrayList<>(space.things());
            Pose there = other.state().pose();
            without.removeIf(disc -> disc.xMm() == there.xMm() && disc.yMm() == there.yMm());
            if (before == null
                    && without.size() < space.things().size()
                    && new PathPlanner(space.with(without)).plan(here, to).isPresent()) {
                before = other;
            }
        }
        waits = (before == null ? "something that its sensors see" : before.name()) + " stands in the way";
    }

    private MotionFailed noWay(String why) {
        return new NoWay("no way to " + destination + ": " + why);
    }

    private Step along(Pose here, FreeSpace space, double left) {
        Way planned = way;
        if (planned == null) {
            refuseLongWait(LONGEST_BLOCKED_S);
            navigator.traffic().reserve(vehicle, new Way(List.of(here)), 0);
            return stand();
        }
        Way rest = planned.from(here);
        makeRoom(here, space);
        if (aside != null && here.distanceMm(aside) < ARRIVED_MM * 2) {
            return standAside(here);
        }
        double restMm = rest.lengthMm() + rest.points().get(0).distanceMm(here);
        if (restMm < leastLeftMm - PROGRESS_MM) {
            leastLeftMm = restMm;
            progressS = now();
        }
        refuseLongWait(isInTraffic() ? LONGEST_TRAFFIC_S : LONGEST_BLOCKED_S);
        return drive(here, space, rest, aside == null ? left : here.distanceMm(aside));
    }

    private Step drive(Pose here, FreeSpace space, Way rest, double left) {
        double cruise = cruise();
        double brakingMm = Room.brakingMm(speed);
        TeamTraffic.Grant grant = navigator.traffic().reserve(vehicle, rest, brakingMm + cruise * 0.6 + 300);
        double allowed = Math.min(cruise, END_PER_S * left + SLOW_MM_PER_S / 2);
        if (grant.before() != null) {
            allowed = Math.min(allowed, speedFor(grant.mm() - FreeSpace.MARGIN_MM));
            waitFor(grant);
        }
        FreeSpace all = space.with(things(true, true));
        if (robot.profile().estimates()) {
            return byPieces(here, all, rest, grant.before() == null ? Double.POSITIVE_INFINITY : grant.mm());
        }
        double[] fractions = {1, 0.5, 0.25};
        Arc best = null;
        for (double fraction : fractions) {
            Arc arc = new Arc(here, all, rest, Math.max(60, fraction * Math.max(AHEAD_MM, AHEAD_S * allowed)));
            if (best == null || arc.freeMm > best.freeMm + 50) {
                best = arc;
            }
            if (best.freeMm >= brakingMm + 200) {
                break;
            }
        }
        if (best == null) {
            return stand();
        }
        if (Math.abs(best.bearing) > ON_THE_SPOT_DEG) {
            return onTheSpot(best.bearing, left);
        }
        allowed = Math.min(allowed, speedFor(best.freeMm - FreeSpace.MARGIN_MM / 2));
        if (allowed < SLOW_MM_PER_S && grant.before() == null) {
            Pose near = rest.at(rest.points().get(0).distanceMm(here) + 150);
            double bearing = bearing(here, near);
            if (Math.abs(bearing) > LEAST_TURN_DEG) {
                return onTheSpot(bearing, left);
            }
            explainBlock(here);
        }
        double waitedS = navigator.traffic().noteWait(vehicle, allowed < SLOW_MM_PER_S && before != null);
        if (aside != null && waitedS > OTHER_WAY_S) {
            goOn();
            return stand();
        }
        if (waitedS > OTHER_WAY_S && now() - aroundS > AROUND_S) {
            aroundS = now();
            plannedS = Double.NEGATIVE_INFINITY;
        }
        if (allowed < SLOW_MM_PER_S) {
            return stand();
        }
        goesOn();
        return roll(allowed, best);
    }

    private void goesOn() {
        waits = "";
        before = null;
        navigator.traffic().noteWait(vehicle, false);
    }

    /** Says what keeps the robot from driving where its way is free of reservations. */
    private void explainBlock(Pose here) {
        before = navigator.others(robot).stream()
                .filter(other ->
                        other.state().pose().distanceMm(here) < TeamTraffic.apartMm(robot, other) + 2 * LEFT_WAY_MM)
                .findFirst()
                .orElse(null);
        waits = (before == null ? "something that its sensors see" : before.name()) + " stands in the way";
    }

    /** Whether it may be another robot under way for which it waits. */
    private boolean isInTraffic() {
        MajicBot other = before;
        return aside != null
                || (other == null
                        ? waits.isEmpty() && navigator.traffic().isBusy()
                        : navigator.traffic().isUnderWay(other));
    }

    private PathPlanner planner(FreeSpace space) {
        return new PathPlanner(space, navigator.traffic().isBusy());
    }

    /** Turns and straight pieces, for a robot that estimates its place by the commands that it got. */
    private Step byPieces(Pose here, FreeSpace space, Way rest, double granted) {
        Pose target = rest.at(PIECE_MM);
        double bearing = bearing(here, target);
        double distance = here.distanceMm(target);
        if (Math.abs(bearing) > PIECE_DEG && distance > NEARLY_MM) {
            return new Turn(bearing);
        }
        double free = Math.min(space.freeMm(here, 0, distance), granted);
        if (free < Math.min(distance, LEAST_PIECE_MM)) {
            explainBlock(here);
            navigator.traffic().noteWait(vehicle, before != null);
            return stand();
        }
        goesOn();
        return new Move(Math.min(distance, free));
    }

    @Override
    public boolean isBlocked() {
        Pose here = robot.state().pose();
        look(here);
        return new FreeSpace(map, bodyMm, things(true, true)).freeMm(here, 0, LEAST_PIECE_MM) < LEAST_PIECE_MM / 2;
    }

    private void look(Pose here) {
        if (looksAhead) {
            seen.lookAhead(here.seenFrom(robot.odometryOrigin()));
        }
    }

    private Step onTheSpot(double bearing, double left) {
        if (speed > 0) {
            return stand();
        }
        if (left <= NEARLY_MM) {
            turnsAtEnd = Math.max(1, turnsAtEnd);
            return Drive.STAND;
        }
        return new Turn(bearing);
    }

    /** Drives along an arc as fast as it and the robot allow. */
    private Step roll(double allowed, Arc arc) {
        double slowest = Math.min(robot.profile().slowestMmPerSec(), allowed);
        double most = robot.profile().turn().max() * 0.8;
        double bend = Math.abs(arc.degPerMm);
        double fast = bend == 0 ? allowed : Math.min(allowed, Math.min(most, cruiseTurn()) / bend);
        fast *= Math.max(0.3, Math.cos(Math.toRadians(arc.bearing)));
        double faster = speed + ACCELERATION_MM_PER_S2 * PERIOD_S * 2;
        speed = Math.max(slowest, Math.min(fast, Math.max(faster, SLOW_MM_PER_S)));
        return new Drive(rounded(speed, 5), rounded(speed * arc.degPerMm, 0.5));
    }

    /** Small differences are not worth a command. */
    private static double rounded(double value, double step) {
        return Math.round(value / step) * step;
    }

    private double cruise() {
        return robot.get("cruise").number();
    }

    private double cruiseTurn() {
        return robot.get("cruiseTurn").number();
    }

    /** The speed from which the robot comes to rest within a distance. */
    private static double speedFor(double mm) {
        return new Room(mm, "").speedMmPerSec();
    }

    private static double bearing(Pose here, Pose to) {
        double direction = Math.toDegrees(Math.atan2(to.yMm() - here.yMm(), to.xMm() - here.xMm()));
        return Pose.normalised(direction - here.headingDeg());
    }

    /** An arc that leads to a point of the way, and how far it is free; infinite if nothing is in the way. */
    private static final class Arc {
        final double bearing;
        final double degPerMm;
        final double freeMm;

        Arc(Pose here, FreeSpace space, Way rest, double aheadMm) {
            Pose target = rest.at(aheadMm);
            double distance = Math.max(1, here.distanceMm(target));
            bearing = GoalCourse.bearing(here, target);
            double chord = 2 * Math.sin(Math.toRadians(Math.max(-90, Math.min(90, bearing)))) / distance;
            degPerMm = Math.toDegrees(chord);
            double look = Math.max(distance, Math.min(LOOK_ARC_MM, rest.lengthMm()));
            double free = Math.abs(bearing) > ON_THE_SPOT_DEG ? 0 : space.freeMm(here, degPerMm, look);
            freeMm = free >= look ? Double.POSITIVE_INFINITY : free;
        }
    }

    /** Fails after a time without progress, and after many times the time that the way should take. */
    private void refuseLongWait(double longestS) {
        String why = waits.isEmpty() ? "it makes no way" : waits;
        if (now() - progressS > longestS) {
            throw new NoWay(why + " for " + Math.round(longestS) + " s");
        }
        if (now() - begunS > longestWholeS) {
            throw new NoWay("it has not arrived after " + Math.round(longestWholeS) + " s; at last, " + why);
        }
    }

    private void waitFor(TeamTraffic.Grant grant) {
        MajicBot other = grant.before();
        before = other;
        waits = other == null ? "" : other.name() + " stands in the way";
    }

    /** Makes room for a robot that goes first, waits, and needs the place where this one is. */
    private void makeRoom(Pose here, FreeSpace space) {
        if (aside != null || now() - asideS < AGAIN_ASIDE_S) {
            return;
        }
        TeamTraffic traffic = navigator.traffic();
        TeamTraffic.Vehicle first =
                traffic.toMakeRoomFor(vehicle, MAKE_ROOM_MM, MAKE_ROOM_S).orElse(null);
        if (first == null) {
            return;
        }
        Predicate<Pose> isAside = place -> traffic.isAside(first, robot, place, MAKE_ROOM_MM)
                && space.mm(place.xMm(), place.yMm()) > ASIDE_ROOM_MM;
        Optional<Way> found = new PathPlanner(space.with(things(true, false)))
                .planToNearest(here, MAKE_ROOM_MM, isAside)
                .or(() -> new PathPlanner(space).planToNearest(here, MAKE_ROOM_MM, isAside));
        asideS = now();
        found.ifPresent(there -> {
            way = there;
            aside = there.end();
            plannedS = now();
            roomFor = first;
            traffic.standIn(vehicle, first);
        });
    }

    /** Waits until the other one has passed. */
    private Step standAside(Pose here) {
        TeamTraffic traffic = navigator.traffic();
        traffic.reserve(vehicle, new Way(List.of(here)), 0);
        TeamTraffic.Vehicle other = roomFor;
        waits = "it makes room for "
                + (other == null ? "another robot" : other.robot().name());
        if (now() - lookedS < LOOK_S) {
            return stand();
        }
        lookedS = now();
        boolean passed = other == null
                || !traffic.isUnderWay(other)
                || traffic.leadsThrough(other, robot, here, MAKE_ROOM_MM)
                || !crosses(traffic, other, here)
                || now() - asideS > LONGEST_BLOCKED_S;
        if (passed) {
            goOn();
        }
        return stand();
    }

    /** Ends making room, and takes its own way again. */
    private void goOn() {
        aside = null;
        roomFor = null;
        way = null;
        asideS = now();
        plannedS = Double.NEGATIVE_INFINITY;
        navigator.traffic().takeBack(vehicle);
    }

    /** Whether the rest of another one's way still leads along the way that this robot would take. */
    private boolean crosses(TeamTraffic traffic, TeamTraffic.Vehicle other, Pose here) {
        Optional<Way> own =
                new PathPlanner(new FreeSpace(map, bodyMm, things(false, false))).plan(here, destination.pose());
        if (own.isEmpty()) {
            return false;
        }
        for (double mm = 0; mm < Math.min(MAKE_ROOM_MM / 4, own.get().lengthMm()); mm += 100) {
            if (traffic.leadsThrough(other, robot, own.get().at(mm), MAKE_ROOM_MM)) {
                return true;
            }
        }
        return false;
    }
}
