package majicsim.world;

/** Finds the shortest distance between two shapes; for one use. */
final class GapFinder {
    private final Shape a;
    private final Shape b;
    private double bestSquare = Double.POSITIVE_INFINITY;
    private double fromX;
    private double fromY;
    private double atX;
    private double atY;

    GapFinder(Shape a, Shape b) {
        this.a = a;
        this.b = b;
    }

    Gap find() {
        if (!overlap()) {
            cornersOfAToEdgesOfB();
            cornersOfBToEdgesOfA();
        }
        return new Gap(Math.sqrt(bestSquare) - a.roundMm - b.roundMm, nearest());
    }

    /** The point on the second shape's rounded edge, not on its skeleton. */
    private Point nearest() {
        double outwards = bestSquare > 0 ? b.roundMm / Math.sqrt(bestSquare) : 0;
        return new Point(atX + outwards * (fromX - atX), atY + outwards * (fromY - atY));
    }

    private boolean overlap() {
        if (b.contains(a.xs[0], a.ys[0])) {
            offer(a.xs[0], a.ys[0], a.xs[0], a.ys[0]);
            return true;
        }
        if (a.contains(b.xs[0], b.ys[0])) {
            offer(b.xs[0], b.ys[0], b.xs[0], b.ys[0]);
            return true;
        }
        return edgesCross();
    }

    private boolean edgesCross() {
        for (int i = 0; i < a.edges(); i++) {
            for (int k = 0; k < b.edges(); k++) {
                if (cross(i, k)) {
                    return true;
                }
            }
        }
        return false;
    }

    private boolean cross(int i, int k) {
        int j = a.next(i);
        int m = b.next(k);
        double ax = a.xs[j] - a.xs[i];
        double ay = a.ys[j] - a.ys[i];
        double bx = b.xs[m] - b.xs[k];
        double by = b.ys[m] - b.ys[k];
        double determinant = ax * by - ay * bx;
        if (determinant == 0) {
            return false;
        }
        double dx = b.xs[k] - a.xs[i];
        double dy = b.ys[k] - a.ys[i];
        double alongA = (dx * by - dy * bx) / determinant;
        double alongB = (dx * ay - dy * ax) / determinant;
        if (alongA < 0 || alongA > 1 || alongB < 0 || alongB > 1) {
            return false;
        }
        double x = a.xs[i] + alongA * ax;
        double y = a.ys[i] + alongA * ay;
        offer(x, y, x, y);
        return true;
    }

    private void cornersOfAToEdgesOfB() {
        for (int i = 0; i < a.corners(); i++) {
            for (int k = 0; k < Math.max(1, b.edges()); k++) {
                double along = b.along(a.xs[i], a.ys[i], k);
                double x = pointX(b, k, along);
                double y = pointY(b, k, along);
                offer(a.xs[i], a.ys[i], x, y);
            }
        }
    }

    private void cornersOfBToEdgesOfA() {
        for (int i = 0; i < b.corners(); i++) {
            for (int k = 0; k < Math.max(1, a.edges()); k++) {
                double along = a.along(b.xs[i], b.ys[i], k);
                double x = pointX(a, k, along);
                double y = pointY(a, k, along);
                offer(x, y, b.xs[i], b.ys[i]);
            }
        }
    }

    private static double pointX(Shape shape, int k, double along) {
        return shape.xs[k] + along * (shape.xs[shape.next(k)] - shape.xs[k]);
    }

    private static double pointY(Shape shape, int k, double along) {
        return shape.ys[k] + along * (shape.ys[shape.next(k)] - shape.ys[k]);
    }

    /** A point of the first shape and one of the second. */
    private void offer(double ofAX, double ofAY, double ofBX, double ofBY) {
        double dx = ofAX - ofBX;
        double dy = ofAY - ofBY;
        double square = dx * dx + dy * dy;
        if (square < bestSquare) {
            bestSquare = square;
            fromX = ofAX;
            fromY = ofAY;
            atX = ofBX;
            atY = ofBY;
        }
    }
}
