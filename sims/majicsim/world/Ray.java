package majicsim.world;

/** One ray that is shortened to what it meets. */
final class Ray {
    private final double x;
    private final double y;
    private final double dx;
    private final double dy;
    private double lengthMm;
    private double squareness = 1;
    private double reflectivity;

    Ray(double xMm, double yMm, double directionDeg, double maxMm) {
        double angle = Math.toRadians(Pose.normalised(directionDeg));
        x = xMm;
        y = yMm;
        dx = Math.cos(angle);
        dy = Math.sin(angle);
        lengthMm = maxMm;
    }

    Hit hit() {
        return new Hit(lengthMm, squareness, reflectivity);
    }

    /** To what it meets first, as far as it was compared. */
    double lengthMm() {
        return lengthMm;
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
        return Math.abs(toX * dy - toY * dx) <= reachMm && along >= -reachMm && along <= lengthMm + reachMm;
    }

    void meet(Shape shape, double reflects) {
        if (shape.corners() == 1) {
            meetDisc(shape, reflects);
            return;
        }
        for (int i = 0; i < shape.edges(); i++) {
            meetEdge(shape, i, reflects);
        }
    }

    private void meetDisc(Shape disc, double reflects) {
        double toX = disc.xs[0] - x;
        double toY = disc.ys[0] - y;
        double along = toX * dx + toY * dy;
        double aside = toX * dy - toY * dx;
        if (Math.abs(aside) >= disc.roundMm) {
            return;
        }
        double distance = along - Math.sqrt(disc.roundMm * disc.roundMm - aside * aside);
        if (distance >= 0 && distance < lengthMm) {
            double sine = aside / disc.roundMm;
            end(distance, Math.sqrt(1 - sine * sine), reflects);
        }
    }

    private void meetEdge(Shape shape, int i, double reflects) {
        int j = shape.next(i);
        double ex = shape.xs[j] - shape.xs[i];
        double ey = shape.ys[j] - shape.ys[i];
        double determinant = dx * ey - dy * ex;
        if (determinant == 0) {
            return;
        }
        double toX = shape.xs[i] - x;
        double toY = shape.ys[i] - y;
        double alongEdge = (toX * dy - toY * dx) / determinant;
        if (alongEdge >= 0 && alongEdge <= 1) {
            double distance = (toX * ey - toY * ex) / determinant;
            if (distance >= 0 && distance < lengthMm) {
                end(distance, Math.min(1, Math.abs(determinant) / Math.sqrt(ex * ex + ey * ey)), reflects);
            }
        }
    }

    private void end(double distance, double square, double reflects) {
        lengthMm = distance;
        squareness = square;
        reflectivity = reflects;
    }
}
