package majicsim.world;

/** One ray that is shortened to what it meets. */
final class Ray {
    private final double x;
    private final double y;
    private final double dx;
    private final double dy;
    private Hit hit;

    Ray(Pose from, double maxMm) {
        x = from.xMm();
        y = from.yMm();
        dx = Math.cos(Math.toRadians(from.headingDeg()));
        dy = Math.sin(Math.toRadians(from.headingDeg()));
        hit = Hit.nothing(maxMm);
    }

    Hit hit() {
        return hit;
    }

    /** To what it meets first, as far as it was compared. */
    double lengthMm() {
        return hit.distanceMm();
    }

    double xAt(double alongMm) {
        return x + alongMm * dx;
    }

    double yAt(double alongMm) {
        return y + alongMm * dy;
    }

    void meet(Body body) {
        if (passesNear(body.pose(), body.reachMm())) {
            meet(body.shape(), Body.REFLECTIVITY);
        }
    }

    /** Whether it may meet something that reaches so far from there. */
    private boolean passesNear(Pose place, double reachMm) {
        double toX = place.xMm() - x;
        double toY = place.yMm() - y;
        double along = toX * dx + toY * dy;
        return Math.abs(toX * dy - toY * dx) <= reachMm && along >= -reachMm && along <= hit.distanceMm() + reachMm;
    }

    void meet(Shape shape, double reflectivity) {
        if (shape.corners() == 1) {
            meetDisc(shape, reflectivity);
            return;
        }
        for (int i = 0; i < shape.edges(); i++) {
            meetEdge(shape, i, reflectivity);
        }
    }

    private void meetDisc(Shape disc, double reflectivity) {
        double toX = disc.xs[0] - x;
        double toY = disc.ys[0] - y;
        double along = toX * dx + toY * dy;
        double aside = toX * dy - toY * dx;
        if (Math.abs(aside) >= disc.roundMm) {
            return;
        }
        double distance = along - Math.sqrt(disc.roundMm * disc.roundMm - aside * aside);
        if (distance >= 0 && distance < hit.distanceMm()) {
            hit = new Hit(distance, Math.toDegrees(Math.asin(Math.abs(aside) / disc.roundMm)), reflectivity);
        }
    }

    private void meetEdge(Shape shape, int i, double reflectivity) {
        int j = shape.next(i);
        double ex = shape.xs[j] - shape.xs[i];
        double ey = shape.ys[j] - shape.ys[i];
        double determinant = dx * ey - dy * ex;
        if (determinant == 0) {
            return;
        }
        double toX = shape.xs[i] - x;
        double toY = shape.ys[i] - y;
        double distance = (toX * ey - toY * ex) / determinant;
        double alongEdge = (toX * dy - toY * dx) / determinant;
        if (distance >= 0 && distance < hit.distanceMm() && alongEdge >= 0 && alongEdge <= 1) {
            double square = Math.min(1, Math.abs(determinant) / Math.sqrt(ex * ex + ey * ey));
            hit = new Hit(distance, Math.toDegrees(Math.acos(square)), reflectivity);
        }
    }
}
