package majic.nav;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import majic.bot.Beam;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.bot.ScanListener;
import majic.bot.Value;

/**
 * What the sensors of one robot have seen around it lately, as points in the frame of its odometry. A point is
 * forgotten when a beam passes through it, or after some seconds. Thread-safe.
 */
final class SeenObstacles implements ScanListener {
    /** Farther echoes do not matter yet, and those of sonars say little of a place. */
    private static final double FARTHEST_MM = 3000;

    private static final double FARTHEST_OF_SONAR_MM = 1500;
    private static final double KEPT_S = 10;

    /** What the map has as well is kept for as long as it takes to pass it by. */
    private static final double KNOWN_KEPT_S = 1.5;

    private static final double CELL_MM = 50;

    /** The echo of a sonar is somewhere on an arc, which is taken as points of this distance. */
    private static final double ARC_MM = 120;

    /** A beam that goes as much farther than a point shows that it is free. */
    private static final double THROUGH_MM = 150;

    /** The middle part of a sonar's beam, in which it would have seen a point. */
    private static final double SURE_PART = 0.6;

    private final MajicBot robot;
    private final Known known;

    /** The part of a sonar's beam from all of which its echo may come. */
    private final double arcPart;

    private final Map<Long, Point> points = new HashMap<>();
    private long scannedNanos;
    private boolean hasScanned;

    /** What the echoes are compared with. */
    interface Known {
        /** Whether an echo at a place in the frame of the robot's poses is one of the map, or of another robot. */
        boolean explains(double xMm, double yMm);
    }

    /** A place in the frame of the odometry, and whether something known explains what was seen there. */
    record Point(double xMm, double yMm, long seenNanos, boolean known) {
        private long cell() {
            return Math.round(xMm / CELL_MM) << 32 ^ Math.round(yMm / CELL_MM) & 0xFFFFFFFFL;
        }
    }

    SeenObstacles(MajicBot robot, Known known) {
        this(robot, known, 1);
    }

    private SeenObstacles(MajicBot robot, Known known, double arcPart) {
        this.robot = robot;
        this.known = known;
        this.arcPart = arcPart;
        this.scannedNanos = robot.time().nanos();
    }

    /**
     * All that the sensors see, whether the map has it or not. The echo of a sonar is taken to be in the middle of its
     * beam: the walls of a corridor would stand in the way of the robot otherwise.
     */
    static SeenObstacles ofAll(MajicBot robot) {
        return new SeenObstacles(robot, (xMm, yMm) -> false, 0);
    }

    /** Returns whether a robot without described range sensors measures what is ahead of it. */
    static boolean looksAhead(MajicBot robot) {
        return robot.rangeSensors().isEmpty() && HullDistance.ahead(robot).isMeasured();
    }

    /** Returns how far the sensors of a robot see at most, as far as it counts here. */
    static double viewMm(MajicBot robot) {
        return robot.rangeSensors().stream().anyMatch(RangeSensor::isLaser) ? FARTHEST_MM : FARTHEST_OF_SONAR_MM;
    }

    /** The time since the last scan, or since the beginning, s. */
    synchronized double ageS() {
        return robot.time().secondsSince(scannedNanos);
    }

    /** Whether there has been a scan. */
    synchronized boolean hasScanned() {
        return hasScanned;
    }

    /** Returns what has been seen, in the frame of the odometry. */
    synchronized List<Point> points() {
        points.values()
                .removeIf(point ->
                        robot.time().secondsSince(point.seenNanos()) > (point.known() ? KNOWN_KEPT_S : KEPT_S));
        return List.copyOf(points.values());
    }

    @Override
    public synchronized void scanned(RangeScan scan) {
        scannedNanos = robot.time().nanos();
        hasScanned = true;
        boolean laser = scan.sensor().isLaser();
        List<Point> echoes = new ArrayList<>();
        List<Ray> rays = new ArrayList<>();
        for (int index = 0; index < scan.size(); index++) {
            Beam beam = scan.sensor().beams().get(index);
            Pose sensor = scan.odometry().plus(beam.mount());
            double range = scan.rangeMm(index);
            if (!Double.isNaN(range)) {
                rays.add(new Ray(sensor, laser ? beam.openingDeg() : SURE_PART * beam.openingDeg(), beam, range));
            }
            if (range < (laser ? FARTHEST_MM : FARTHEST_OF_SONAR_MM)) {
                addEcho(echoes, sensor, range, laser ? 0 : arcPart * beam.openingDeg());
            }
        }
        points.values().removeIf(point -> rays.stream().anyMatch(ray -> ray.passes(point)));
        echoes.forEach(point -> points.put(point.cell(), point));
    }

    /** Adds the places where an echo may come from; none of a sonar's arc of which a part is explained. */
    private void addEcho(List<Point> echoes, Pose sensor, double range, double openingDeg) {
        List<Point> arc = new ArrayList<>();
        Pose origin = robot.odometryOrigin();
        int steps = (int) Math.ceil(Math.toRadians(openingDeg) * range / ARC_MM);
        for (int step = 0; step <= steps; step++) {
            double angle = steps == 0 ? 0 : openingDeg * ((double) step / steps - 0.5);
            Pose echo = sensor.plus(new Pose(0, 0, angle)).after(range, 0);
            Pose place = origin.plus(echo);
            boolean explained = known.explains(place.xMm(), place.yMm());
            if (explained && steps > 0) {
                return;
            }
            arc.add(new Point(echo.xMm(), echo.yMm(), scannedNanos, explained));
        }
        echoes.addAll(arc);
    }

    /** A beam as it was measured. */
    private static final class Ray {
        private final Pose from;
        private final double cos;
        private final double sin;
        private final double tan;
        private final double least;
        private final double most;

        Ray(Pose from, double openingDeg, Beam beam, double range) {
            this.from = from;
            cos = Math.cos(Math.toRadians(from.headingDeg()));
            sin = Math.sin(Math.toRadians(from.headingDeg()));
            tan = Math.tan(Math.toRadians(openingDeg / 2));
            least = beam.leastMm();
            most = Math.min(range, beam.reachMm()) - THROUGH_MM;
        }

        /** Whether it goes through a point and farther. */
        boolean passes(Point point) {
            double dx = point.xMm() - from.xMm();
            double dy = point.yMm() - from.yMm();
            double ahead = cos * dx + sin * dy;
            return ahead > least && ahead < most && Math.abs(cos * dy - sin * dx) <= ahead * tan;
        }
    }

    /**
     * Adds what a robot without described range sensors measures ahead of its hull. A value that is not current is no
     * reading.
     */
    void lookAhead(Pose odometry) {
        HullDistance distance = HullDistance.ahead(robot);
        Value ahead = distance.now();
        if (ahead instanceof Value.Unknown) {
            return;
        }
        synchronized (this) {
            scannedNanos = robot.time().nanos();
            if (ahead instanceof Value.Number number && number.amount() < FARTHEST_OF_SONAR_MM) {
                List<Point> echoes = new ArrayList<>();
                addEcho(echoes, odometry, distance.fromCentreMm(number), 0);
                echoes.forEach(point -> points.put(point.cell(), point));
            }
        }
    }
}
