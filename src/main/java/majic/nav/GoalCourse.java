package majic.nav;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import majic.bot.Course;
import majic.bot.DriveGuard.Room;
import majic.bot.Fence;
import majic.bot.MajicBot;
import majic.bot.MotionFailed;
import majic.bot.Pose;
import majic.bot.Value;
import majic.nav.path.FreeSpace;
import majic.nav.path.Way;

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

    /** The room behind or ahead that a robot needs to drive away from what is beside it. */
    private static final double LEAVE_MM = 150;

    private static final double LEAVE_MM_PER_S = 60;

    /** The point ahead on the way, in time and at least. */
    private static final double AHEAD_S = 0.9;

    private static final double AHEAD_MM = 250;

    /** How far an arc is looked along. */
    private static final double LOOK_ARC_MM = 1200;

    /**
     * The straight pieces of a robot that estimates its place: as long as its way is straight, or along it. Each end of
     * a piece costs a stop.
     */
    private static final double PIECE_MM = 400;

    private static final double LONGEST_PIECE_MM = 1500;

    private static final double LEAST_PIECE_MM = 40;
    private static final double PIECE_DEG = 4;

    /** When another way around the other robots is tried. */
    private static final double OTHER_WAY_S = 3;

    /** Another robot with as little room between is what keeps this one from driving. */
    private static final double NEAR_MM = 600;

    private final MajicBot robot;
    private final Destination destination;
    private final TeamSpace team;
    private final LocalSpace local;
    private final TeamTraffic.Vehicle vehicle;
    private final PlannedWay planned;
    private final Yielding yielding;
    private final Waiting waiting;
    private final RoomRequests requests;
    private final TurningRoom turning;
    private final double bodyMm;
    private double speed;
    private int turnsAtEnd;

    GoalCourse(MajicBot robot, Destination destination, TeamSpace team) {
        robot.fence().ifPresent(fence -> refuseOutside(fence, destination));
        this.robot = robot;
        this.destination = destination;
        this.team = team;
        this.bodyMm = robot.profile().bodyMm();
        this.local = new LocalSpace(robot, destination, team);
        this.requests = new RoomRequests(robot, destination, local, team);
        this.turning = new TurningRoom(robot, local);
        this.vehicle = team.traffic().begin(robot);
        this.waiting = new Waiting(team.traffic(), vehicle);
        this.planned = new PlannedWay(local, destination, team, vehicle);
        this.yielding = new Yielding(local, planned, destination, team.traffic(), vehicle);
        local.open();
    }

    private static void refuseOutside(Fence fence, Destination destination) {
        Pose to = destination.pose();
        if (fence.insideMm(to.xMm(), to.yMm()) < 0) {
            throw new NoWay(destination + " is " + fence.distance(to.xMm(), to.yMm())
                    + " from home, outside of the fence of " + fence.radius() + "; \"set fence\" sets a larger one");
        }
    }

    @Override
    public void close() {
        local.close();
        team.traffic().end(vehicle);
    }

    @Override
    public Value amount() {
        return place(robot);
    }

    /** Returns where a robot is, as its parameters have it: answers mark what it estimates. */
    static Value place(MajicBot robot) {
        return Value.many(Stream.of("x", "y", "heading").map(robot::get).toList());
    }

    @Override
    public Step next() {
        Step step = decide();
        team.traffic().explain(vehicle, step == Drive.STAND ? waiting.reason() : null);
        return step;
    }

    private Step decide() {
        Pose here = robot.state().pose();
        local.lookAtOthers();
        refuseUncertain(here);
        local.lookAhead(here);
        if (local.isBlind(OLDEST_S)) {
            throw new MotionFailed("no reading of its range sensors for 1 s");
        }
        double left = here.distanceMm(destination.pose());
        if (left <= ARRIVED_MM || left <= NEARLY_MM && turnsAtEnd > 0) {
            return arrived(here);
        }
        local.lookAtMap();
        FreeSpace space = local.beside();
        plan(here, space);
        return along(here, space, left);
    }

    private void refuseUncertain(Pose here) {
        if (robot.time().secondsSince(robot.state().atNanos()) > OLDEST_S) {
            throw new MotionFailed("no report of the robot for 1 s");
        }
        if (!team.hasMap()) {
            return;
        }
        if (!robot.uncertainty().isKnown()) {
            throw new MotionFailed("its place on the map is not known; \"set pose\" or \"localize\" places it");
        }
        double sigma = robot.uncertainty().sigmaMm();
        double free = local.map().mm(here.xMm(), here.yMm());
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
        if (!turning.allows(here)) {
            return standBeside(here);
        }
        turnsAtEnd++;
        return new Turn(wrong);
    }

    /** Waits for something beside the robot before it turns, and drives straight away from what stays too near. */
    private Step standBeside(Pose here) {
        explainBlock(here);
        waiting.refuseLongWithoutWay();
        if (turning.hasToLeave()) {
            FreeSpace space = local.now();
            Pose back = new Pose(here.xMm(), here.yMm(), here.headingDeg() + 180);
            if (space.freeMm(back, 0, LEAVE_MM) == LEAVE_MM) {
                return new Drive(-LEAVE_MM_PER_S, 0);
            }
            if (space.freeMm(here, 0, LEAVE_MM) == LEAVE_MM) {
                return new Drive(LEAVE_MM_PER_S, 0);
            }
            turning.cannotLeave();
        }
        return standAndGiveBack();
    }

    /** Stands; what is reserved ahead is given back once the robot is stationary. */
    private Step standAndGiveBack() {
        if (speed == 0 && !robot.state().moving()) {
            team.traffic().giveBack(vehicle);
        }
        return stand();
    }

    private Step stand() {
        speed = 0;
        return Drive.STAND;
    }

    private void plan(Pose here, FreeSpace space) {
        switch (planned.plan(here, space)) {
            case NOT_DUE -> {}
            case FOUND -> planned.way().ifPresent(way -> waiting.planned(way.lengthMm(), cruise()));
            case NO_WAY -> explainNoWay(here, space);
        }
    }

    private void explainNoWay(Pose here, FreeSpace space) {
        if (yielding.isActive()) {
            yielding.end();
        } else {
            Optional<MajicBot> standing = planned.obstacle(here, space);
            waiting.standsBehind(standing.orElse(null));
            waiting.remark(standing.map(other -> requests.ask(other, here)).orElse(""));
        }
    }

    private Step along(Pose here, FreeSpace space, double left) {
        Way way = planned.way().orElse(null);
        if (way == null) {
            waiting.refuseLongWithoutWay();
            team.traffic().reserve(vehicle, new Way(List.of(here)), 0);
            return stand();
        }
        yielding.makeRoom(here, space);
        double aheadMm = planned.aside().map(here::distanceMm).orElse(left);
        if (yielding.isActive() && aheadMm < ARRIVED_MM * 2) {
            waiting.standsAsideFor(yielding.standAside(here));
            return stand();
        }
        Way rest = way.from(here);
        waiting.left(rest.lengthMm() + rest.points().get(0).distanceMm(here));
        waiting.refuseLong(yielding.isActive());
        return drive(here, rest, aheadMm);
    }

    private Step drive(Pose here, Way rest, double left) {
        double cruise = cruise();
        double brakingMm = Room.brakingMm(speed);
        double pieceMm = pieceMm(here, rest);
        boolean estimates = robot.profile().estimates();
        TeamTraffic.Grant grant =
                team.traffic().reserve(vehicle, rest, estimates ? pieceMm : brakingMm + cruise * 0.6 + 300);
        double allowed = Math.min(cruise, END_PER_S * left + SLOW_MM_PER_S / 2);
        if (grant.before() != null) {
            allowed = Math.min(allowed, speedFor(grant.mm() - FreeSpace.MARGIN_MM));
            waiting.standsBehind(grant.before());
        }
        FreeSpace all = local.now();
        if (estimates) {
            return byPieces(
                    here, all, rest.at(pieceMm), grant.before() == null ? Double.POSITIVE_INFINITY : grant.mm());
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
            return onTheSpot(here, best.bearing, left);
        }
        allowed = Math.min(allowed, speedFor(best.freeMm - FreeSpace.MARGIN_MM / 2));
        if (allowed < SLOW_MM_PER_S && grant.before() == null) {
            Pose near = rest.at(rest.points().get(0).distanceMm(here) + 150);
            double bearing = bearing(here, near);
            if (Math.abs(bearing) > LEAST_TURN_DEG) {
                return onTheSpot(here, bearing, left);
            }
            explainBlock(here);
        }
        double waitedS = waiting.note(allowed < SLOW_MM_PER_S);
        if (yielding.isActive() && waitedS > OTHER_WAY_S) {
            yielding.end();
            return stand();
        }
        if (waitedS > OTHER_WAY_S) {
            planned.tryAround();
        }
        if (allowed < SLOW_MM_PER_S) {
            return standAndGiveBack();
        }
        waiting.ends();
        return roll(allowed, best);
    }

    /** Finds out what keeps the robot from driving where its way is free of reservations. */
    private void explainBlock(Pose here) {
        waiting.standsBehind(team.others(robot).stream()
                .filter(other -> other.state().pose().distanceMm(here) < TeamTraffic.apartMm(robot, other) + NEAR_MM)
                .findFirst()
                .orElse(null));
    }

    /** How far along its way a robot that estimates its place drives at once. */
    private static double pieceMm(Pose here, Way rest) {
        double straightMm =
                rest.points().size() < 2 ? 0 : here.distanceMm(rest.points().get(1));
        return Math.max(PIECE_MM, Math.min(LONGEST_PIECE_MM, straightMm));
    }

    /** Turns and straight pieces, for a robot that estimates its place by the commands that it got. */
    private Step byPieces(Pose here, FreeSpace space, Pose target, double granted) {
        double bearing = bearing(here, target);
        double distance = here.distanceMm(target);
        if (Math.abs(bearing) > PIECE_DEG && distance > NEARLY_MM) {
            return new Turn(bearing);
        }
        double free = Math.min(space.freeMm(here, 0, distance), granted);
        if (free < Math.min(distance, LEAST_PIECE_MM)) {
            explainBlock(here);
            waiting.note(true);
            return standAndGiveBack();
        }
        waiting.ends();
        return new Move(Math.min(distance, free));
    }

    @Override
    public boolean isBlocked() {
        Pose here = robot.state().pose();
        local.lookAhead(here);
        return local.now().freeMm(here, 0, LEAST_PIECE_MM) < LEAST_PIECE_MM / 2;
    }

    private Step onTheSpot(Pose here, double bearing, double left) {
        if (speed > 0) {
            return stand();
        }
        if (left <= NEARLY_MM) {
            turnsAtEnd = Math.max(1, turnsAtEnd);
            return Drive.STAND;
        }
        return turning.allows(here) ? new Turn(bearing) : standBeside(here);
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
}
