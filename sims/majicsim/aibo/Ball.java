package majicsim.aibo;

import org.jspecify.annotations.Nullable;

/** The pink ball that may lie in the room: seen by the camera, but nothing that one bumps into. */
final class Ball {
    static final int PINK = 0xFF5AA0;
    private static final double RADIUS_MM = 50;

    private @Nullable Vector centre;

    /** Lays it on the floor, at a place in the room. */
    void lay(double xMm, double yMm) {
        centre = new Vector(xMm, yMm, RADIUS_MM);
    }

    void takeAway() {
        centre = null;
    }

    @Nullable
    Vector centre() {
        return centre;
    }

    /** How large it is for an eye, as the tangent of half its angle. */
    static double size(double distanceMm) {
        return RADIUS_MM / Math.max(RADIUS_MM, distanceMm);
    }

    /** How many of the ray's own lengths it is to the ball; not a number where it passes the ball, or there is none. */
    double met(Vector eye, Vector ray) {
        Vector middle = centre;
        if (middle == null) {
            return Double.NaN;
        }
        Vector to = middle.minus(eye);
        double along = to.dot(ray);
        double square = ray.dot(ray);
        double root = along * along - square * (to.dot(to) - RADIUS_MM * RADIUS_MM);
        return along > 0 && root >= 0 ? (along - Math.sqrt(root)) / square : Double.NaN;
    }

    /** How squarely the surface is met there, 1 in the middle of what is seen of it. */
    double slant(Vector eye, Vector ray, double met) {
        Vector middle = centre == null ? eye : centre;
        Vector normal = eye.plus(ray.times(met)).minus(middle);
        return -normal.dot(ray) / (normal.length() * ray.length());
    }
}
