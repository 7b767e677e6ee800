package majic.nav.path;

import java.util.ArrayList;
import java.util.List;
import majic.bot.Pose;

/**
 * A way of straight pieces. Immutable.
 *
 * @param points its corners, at least one; each with the direction of the piece that ends there
 */
public record Way(List<Pose> points) {
    /** Keeps a copy. */
    public Way {
        points = List.copyOf(points);
    }

    /**
     * Makes a way from one place to another.
     *
     * @param corners the places, whatever their headings
     * @return with the headings of its pieces
     */
    public static Way through(List<Pose> corners) {
        List<Pose> points = new ArrayList<>();
        for (Pose corner : corners) {
            Pose last = points.isEmpty() ? corner : points.get(points.size() - 1);
            double heading = points.isEmpty()
                    ? corner.headingDeg()
                    : Math.toDegrees(Math.atan2(corner.yMm() - last.yMm(), corner.xMm() - last.xMm()));
            points.add(new Pose(corner.xMm(), corner.yMm(), heading));
        }
        return new Way(points);
    }

    /** Returns where it ends. */
    public Pose end() {
        return points.get(points.size() - 1);
    }

    /** Returns its length, mm. */
    public double lengthMm() {
        double length = 0;
        for (int index = 1; index < points.size(); index++) {
            length += points.get(index - 1).distanceMm(points.get(index));
        }
        return length;
    }

    /**
     * Returns the rest of this way for a robot beside it.
     *
     * @param place where the robot is
     * @return a way that begins at the point of this one nearest to it
     */
    public Way from(Pose place) {
        Pose nearest = points.get(0);
        int next = Math.min(1, points.size() - 1);
        double least = Double.POSITIVE_INFINITY;
        for (int index = 1; index < points.size(); index++) {
            Pose foot = foot(place, points.get(index - 1), points.get(index));
            double away = foot.distanceMm(place);
            if (away < least) {
                least = away;
                nearest = foot;
                next = index;
            }
        }
        List<Pose> rest = new ArrayList<>();
        rest.add(nearest);
        rest.addAll(points.subList(next, points.size()));
        return new Way(rest);
    }

    private static Pose foot(Pose place, Pose begin, Pose end) {
        double length = begin.distanceMm(end);
        double along = new Pose(begin.xMm(), begin.yMm(), end.headingDeg()).aheadMm(place);
        double share = length == 0 ? 0 : Math.max(0, Math.min(1, along / length));
        return new Pose(
                begin.xMm() + share * (end.xMm() - begin.xMm()),
                begin.yMm() + share * (end.yMm() - begin.yMm()),
                end.headingDeg());
    }

    /**
     * Returns the place on this way at a distance from its beginning.
     *
     * @param mm the distance
     * @return the end if the way is shorter
     */
    public Pose at(double mm) {
        double left = mm;
        for (int index = 1; index < points.size(); index++) {
            Pose begin = points.get(index - 1);
            Pose end = points.get(index);
            double length = begin.distanceMm(end);
            if (length >= left && length > 0) {
                return new Pose(
                        begin.xMm() + left / length * (end.xMm() - begin.xMm()),
                        begin.yMm() + left / length * (end.yMm() - begin.yMm()),
                        end.headingDeg());
            }
            left -= length;
        }
        return end();
    }
}
