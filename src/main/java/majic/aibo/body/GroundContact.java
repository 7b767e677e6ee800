package majic.aibo.body;

import java.util.List;

/**
 * How a body lies on the ground, seen from the side: on two of its lowest points, with its middle between them. Left
 * and right rest on the same height. Immutable.
 *
 * @param pitchDeg how far the body is raised in front
 * @param heightMm of the body's origin
 */
record GroundContact(double pitchDeg, double heightMm) {
    private static final double TOUCHES_MM = 0.01;

    /**
     * Lays a body down. A body may lie in several ways, a dog that sits also on its nose.
     *
     * @param points what it can rest on, in the body's frame
     * @param measuredDeg the pitch to which its own should be the nearest
     */
    static GroundContact of(List<BodyPoint> points, double measuredDeg) {
        GroundContact nearest = level(points, measuredDeg);
        double off = Double.POSITIVE_INFINITY;
        for (BodyPoint rear : points) {
            for (BodyPoint front : points) {
                double pitch = -Math.toDegrees(Math.atan2(front.z() - rear.z(), front.x() - rear.x()));
                if (Math.abs(pitch - measuredDeg) < off && carries(points, rear, front, pitch)) {
                    off = Math.abs(pitch - measuredDeg);
                    nearest = level(points, pitch);
                }
            }
        }
        return nearest;
    }

    /** Its lowest point touches the ground. */
    private static GroundContact level(List<BodyPoint> points, double pitchDeg) {
        double lowest = points.stream()
                .mapToDouble(point -> point.raised(pitchDeg).z())
                .min()
                .orElse(0);
        return new GroundContact(pitchDeg, -lowest);
    }

    /** Whether the body rests on these two, its middle between them. */
    private static boolean carries(List<BodyPoint> points, BodyPoint rear, BodyPoint front, double pitchDeg) {
        double ground = rear.raised(pitchDeg).z();
        return rear.raised(pitchDeg).x() <= 0
                && front.raised(pitchDeg).x() > 0
                && points.stream().allMatch(point -> point.raised(pitchDeg).z() > ground - TOUCHES_MM);
    }

    /** Where a point of the body is when it lies so. */
    BodyPoint onGround(BodyPoint own) {
        return own.raised(pitchDeg).plus(new BodyPoint(0, 0, heightMm));
    }
}
