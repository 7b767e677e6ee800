package majic.nav;

import java.util.ArrayList;
import java.util.List;
import majic.bot.DriveGuard;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.ScanListener;
import majic.bot.Value;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.OccupancyGrid;
import majic.nav.path.FreeSpace;
import majic.nav.path.FreeSpace.Disc;
import majic.nav.path.ObstacleDistance;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * Finds obstacles for one robot by its range sensors, or by what it measures ahead and behind if it describes none, and
 * of a placed robot by the map and the places of the others as well. Requests scans only while it is asked.
 */
final class ObstacleGuard implements DriveGuard, ScanListener {
    /** Longest age of a reading by which a robot drives, seconds. */
    private static final double OLDEST_S = 1;

    /** Scans are requested for so long after it was asked last, seconds: what was seen is still there then. */
    private static final double KEPT_S = 5;

    /** A robot stops in front of an obstacle by this share of its radius, and by so much at most. */
    private static final double STAND_OFF = 0.5;

    private static final double MOST_STAND_OFF_MM = 100;

    /** How far beyond its braking distance an obstacle is looked for. */
    private static final double BEYOND_MM = 100;

    private static final double STEP_MM = 10;
    private static final Pose BACKWARD = new Pose(0, 0, 180);

    /** Nothing is known where there is no map. */
    private static final ObstacleDistance OPEN =
            new ObstacleDistance(NavigationMap.of(OccupancyGrid.of(Pose.START, 100, 1, 1, (column, row) -> 0.02)));

    private final MajicBot robot;
    private final TeamSpace team;
    private @Nullable SeenObstacles seen;
    private boolean scanned;
    private long begunNanos;
    private long askedNanos;

    ObstacleGuard(MajicBot robot, TeamSpace team) {
        this.robot = robot;
        this.team = team;
        this.askedNanos = robot.time().nanos() - (long) (2 * KEPT_S * 1e9);
    }

    @Override
    public boolean isPossible() {
        return WaitPolicy.without(() -> hasRanges() || distance(1).isMeasured() || isOnMap());
    }

    private boolean hasRanges() {
        return !robot.rangeSensors().isEmpty();
    }

    private HullDistance distance(double ahead) {
        return ahead < 0 ? HullDistance.behind(robot) : HullDistance.ahead(robot);
    }

    private boolean isOnMap() {
        return team.hasMap() && robot.uncertainty().isKnown();
    }

    @Override
    public Room room(double mmPerSec, double degPerSec) {
        boolean hasRanges = hasRanges();
        begin(hasRanges);
        if (robot.time().secondsSince(robot.state().atNanos()) > OLDEST_S) {
            return new Room(0, "no report of the robot for 1 s");
        }
        List<Disc> echoes = new ArrayList<>();
        String missing = hasRanges ? addScans(echoes) : addDistance(mmPerSec, echoes);
        if (!missing.isEmpty()) {
            return isBeginning() ? Room.WAITING : new Room(0, missing);
        }
        return mmPerSec == 0 ? Room.FREE : nearest(mmPerSec, degPerSec / Math.abs(mmPerSec), echoes);
    }

    private synchronized void begin(boolean hasRanges) {
        long now = robot.time().nanos();
        if (now - askedNanos > KEPT_S * 1e9) {
            begunNanos = now;
        }
        askedNanos = now;
        if (hasRanges && seen == null) {
            seen = SeenObstacles.ofAll(robot);
            scanned = false;
            begunNanos = now;
            robot.addScanListener(this);
        }
    }

    private synchronized boolean isBeginning() {
        return !scanned && robot.time().secondsSince(begunNanos) <= OLDEST_S;
    }

    @Override
    public synchronized void scanned(RangeScan scan) {
        SeenObstacles present = seen;
        if (robot.time().secondsSince(askedNanos) > KEPT_S) {
            seen = null;
            robot.removeScanListener(this);
        } else if (present != null) {
            scanned = true;
            present.scanned(scan);
        }
    }

    /** Adds what the range sensors have seen; returns what is missing. */
    private synchronized String addScans(List<Disc> echoes) {
        SeenObstacles present = seen;
        if (present == null || !scanned || present.ageS() > OLDEST_S) {
            return "no reading of its range sensors for 1 s";
        }
        Pose origin = robot.odometryOrigin();
        for (SeenObstacles.Point point : present.points()) {
            Pose place = origin.plus(new Pose(point.xMm(), point.yMm(), 0));
            echoes.add(new Disc(place.xMm(), place.yMm(), 0));
        }
        return "";
    }

    /** Adds what the robot measures on the side to which it drives; returns what is missing. */
    private String addDistance(double ahead, List<Disc> echoes) {
        HullDistance distance = distance(ahead);
        if (!distance.isMeasured()) {
            return "";
        }
        Value value = distance.now();
        if (value instanceof Value.Unknown) {
            return distance.parameter() + " is " + value;
        }
        if (value instanceof Value.Number number) {
            Pose there = robot.state().pose().after(distance.fromCentreMm(number), 0);
            echoes.add(new Disc(there.xMm(), there.yMm(), 0));
        }
        return "";
    }

    private Room nearest(double mmPerSec, double degPerMm, List<Disc> echoes) {
        double body = robot.profile().bodyMm();
        double standOff = Math.min(MOST_STAND_OFF_MM, STAND_OFF * body);
        double view = hasRanges() ? SeenObstacles.viewMm(robot) : Double.POSITIVE_INFINITY;
        double most = Math.min(view, Room.brakingMm(mmPerSec) + standOff + BEYOND_MM);
        Pose here = robot.state().pose();
        FreeWay way = new FreeWay(mmPerSec < 0 ? here.plus(BACKWARD) : here, degPerMm, most);
        way.look(new FreeSpace(OPEN, body, echoes), "something that its sensors see is ");
        if (robot.uncertainty().isKnown()) {
            team.distances(robot)
                    .ifPresent(map -> way.look(new FreeSpace(map, body, List.of()), "a wall of the map is "));
            for (MajicBot other : team.others(robot)) {
                Pose there = other.state().pose();
                Disc disc = new Disc(there.xMm(), there.yMm(), other.profile().bodyMm());
                way.look(new FreeSpace(OPEN, body, List.of(disc)), other.name() + " is ");
            }
        }
        if (way.isFree() && most == view) {
            return new Room(view - standOff, "its sensors see no farther than " + Math.round(view) + " mm");
        }
        return way.room(standOff, mmPerSec < 0 ? " mm behind" : " mm ahead");
    }

    /** How far an arc is free, and what ends it. */
    private static final class FreeWay {
        private final Pose from;
        private final double degPerMm;
        private final double most;
        private double freeMm;
        private String what = "";

        FreeWay(Pose from, double degPerMm, double most) {
            this.from = from;
            this.degPerMm = degPerMm;
            this.most = most;
            this.freeMm = most;
        }

        void look(FreeSpace space, String name) {
            double free = space.freeMm(from, degPerMm, most, STEP_MM);
            if (free < freeMm) {
                freeMm = free;
                what = name;
            }
        }

        boolean isFree() {
            return what.isEmpty();
        }

        Room room(double standOff, String side) {
            long apart = Math.round(freeMm + FreeSpace.MARGIN_MM / 2);
            return isFree() ? Room.FREE : new Room(Math.max(0, freeMm - standOff), what + apart + side);
        }
    }
}
