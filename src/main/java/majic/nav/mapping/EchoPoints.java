package majic.nav.mapping;

import java.util.Arrays;
import java.util.List;
import majic.bot.Beam;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.nav.mapping.ReferenceGrid.PlacedPoints;

/**
 * The echoes of a scan as points in the robot's frame, mm, each with the direction in which the surface there is seen:
 * the normal of the line through its neighbours. Immutable.
 */
final class EchoPoints {
    /**
     * An echo at a greater distance is not used: there, neighbouring beams of a scanner with steps of 1 degree are 0.5
     * m apart, and an error of the heading of half a degree displaces it by more than a quarter of a metre.
     */
    static final double REACH_MM = 30_000;

    /**
     * Neighbours that are farther apart than this many times the distance between the beams are other surfaces: a wall
     * is recognised down to an angle of 5 degrees between beam and wall.
     */
    private static final double GAP = 12;

    /** Neighbours that are less in line than this, mm, are no surface. */
    private static final double FLAT_MM = 30;

    /** Neighbours on each side of a point that its line is fitted to. */
    private static final int NEIGHBOURS = 3;

    private static final double LEAST_GAP_MM = 100;

    /** Half a cell: an echo closer to the one before says nothing new, and near surfaces would outweigh far ones. */
    private static final double LEAST_STEP_MM = ReferenceGrid.CELL_MM / 2;

    final int count;
    final float[] x;
    final float[] y;

    /** Unit vector from the surface to the side it was seen from, or zero where a point has no neighbours. */
    final float[] normalX;

    final float[] normalY;

    private EchoPoints(int count, float[] x, float[] y, float[] normalX, float[] normalY) {
        this.count = count;
        this.x = x;
        this.y = y;
        this.normalX = normalX;
        this.normalY = normalY;
    }

    static EchoPoints of(RangeScan scan) {
        List<Beam> beams = scan.sensor().beams();
        float[] x = new float[scan.size()];
        float[] y = new float[scan.size()];
        float[] range = new float[scan.size()];
        int count = 0;
        for (int index = 0; index < scan.size(); index++) {
            float mm = scan.rangeMm(index);
            if (mm < REACH_MM) {
                Beam beam = beams.get(index);
                double angle = Math.toRadians(beam.mount().headingDeg());
                x[count] = (float) (beam.mount().xMm() + mm * Math.cos(angle));
                y[count] = (float) (beam.mount().yMm() + mm * Math.sin(angle));
                range[count] = mm;
                if (count == 0 || Math.hypot(x[count] - x[count - 1], y[count] - y[count - 1]) >= LEAST_STEP_MM) {
                    count++;
                }
            }
        }
        EchoPoints points = new EchoPoints(
                count, Arrays.copyOf(x, count), Arrays.copyOf(y, count), new float[count], new float[count]);
        double spacing = spacing(beams);
        for (int index = 0; index < count; index++) {
            points.fitNormal(index, Math.max(LEAST_GAP_MM, GAP * spacing * range[index]));
        }
        return points;
    }

    /** The angle from one beam to the next, rad. */
    private static double spacing(List<Beam> beams) {
        return beams.size() < 2
                ? 0
                : Math.toRadians(Math.abs(Pose.normalised(
                        beams.get(1).mount().headingDeg() - beams.get(0).mount().headingDeg())));
    }

    /** Joins scans at their places, as one scan taken from the given pose. */
    static EchoPoints joined(List<PlacedPoints> scans, Pose from) {
        int count = scans.stream().mapToInt(scan -> scan.points().count).sum();
        EchoPoints all = new EchoPoints(count, new float[count], new float[count], new float[count], new float[count]);
        int next = 0;
        for (PlacedPoints scan : scans) {
            Pose pose = scan.pose().seenFrom(from);
            next = all.copy(scan.points(), pose, next);
        }
        return all;
    }

    private int copy(EchoPoints from, Pose pose, int start) {
        double angle = Math.toRadians(pose.headingDeg());
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        int next = start;
        for (int index = 0; index < from.count; index++, next++) {
            x[next] = (float) (pose.xMm() + cos * from.x[index] - sin * from.y[index]);
            y[next] = (float) (pose.yMm() + sin * from.x[index] + cos * from.y[index]);
            normalX[next] = (float) (cos * from.normalX[index] - sin * from.normalY[index]);
            normalY[next] = (float) (sin * from.normalX[index] + cos * from.normalY[index]);
        }
        return next;
    }

    /** The direction of least spread of a point and its neighbours on the same surface. */
    private void fitNormal(int index, double gap) {
        int from = index;
        while (from > 0 && index - from < NEIGHBOURS && apart(from, from - 1) < gap) {
            from--;
        }
        int to = index;
        while (to < count - 1 && to - index < NEIGHBOURS && apart(to, to + 1) < gap) {
            to++;
        }
        int number = to - from + 1;
        if (number < 3) {
            return;
        }
        double meanX = 0;
        double meanY = 0;
        for (int i = from; i <= to; i++) {
            meanX += x[i] / number;
            meanY += y[i] / number;
        }
        double xx = 0;
        double xy = 0;
        double yy = 0;
        for (int i = from; i <= to; i++) {
            double dx = x[i] - meanX;
            double dy = y[i] - meanY;
            xx += dx * dx;
            xy += dx * dy;
            yy += dy * dy;
        }
        double spread = (xx + yy) / 2 - Math.hypot((xx - yy) / 2, xy);
        if (spread / number > FLAT_MM * FLAT_MM) {
            return;
        }
        double along = 0.5 * Math.atan2(2 * xy, xx - yy);
        double towards = x[index] * Math.sin(along) - y[index] * Math.cos(along) < 0 ? -1 : 1;
        normalX[index] = (float) (-towards * Math.sin(along));
        normalY[index] = (float) (towards * Math.cos(along));
    }

    private double apart(int one, int other) {
        return Math.hypot(x[one] - x[other], y[one] - y[other]);
    }
}
