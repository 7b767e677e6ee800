package majicsim.aibo.scene;

import java.util.List;
import majicsim.world.Body;
import majicsim.world.Point;
import org.jspecify.annotations.Nullable;

/**
 * The part of one vertical slice of the room that a body occupies.
 *
 * @param entryMm where the slice enters it
 * @param exitMm where it leaves it
 * @param slant cosine of the angle of incidence, 1 perpendicular
 */
record BodyInSlice(RobotAppearance look, double entryMm, double exitMm, double slant) {

    /** The part of a body that lies in the direction (dx, dy) of length 1, or null if none does. */
    static @Nullable BodyInSlice of(Body body, Vector eye, double dx, double dy) {
        List<Point> corners = body.outline();
        double entry = Double.POSITIVE_INFINITY;
        double exit = 0;
        double slant = 1;
        for (int i = 0; i < corners.size(); i++) {
            Point a = corners.get(i);
            Point b = corners.get((i + 1) % corners.size());
            double ex = b.xMm() - a.xMm();
            double ey = b.yMm() - a.yMm();
            double across = dx * ey - dy * ex;
            double toX = a.xMm() - eye.x();
            double toY = a.yMm() - eye.y();
            double along = (toX * ey - toY * ex) / across;
            double onEdge = (toX * dy - toY * dx) / across;
            if (!(along >= 0) || onEdge < 0 || onEdge > 1) {
                continue;
            }
            exit = Math.max(exit, along);
            if (along < entry) {
                entry = along;
                slant = Math.abs(across) / Math.hypot(ex, ey);
            }
        }
        return entry <= exit ? new BodyInSlice(RobotAppearance.of(body), entry, exit, slant) : null;
    }
}
