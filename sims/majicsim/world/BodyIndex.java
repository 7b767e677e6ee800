package majicsim.world;

import java.util.ArrayList;
import java.util.List;

/**
 * Lists the bodies in each square of the floor, so that a ray or a body is compared with those near it only, and counts
 * the movements in each square, so that what was computed from them can be kept while nothing moves.
 */
final class BodyIndex {
    private static final double SQUARE_MM = 2500;

    private final Bounds bounds;
    private final int columns;
    private final int rows;
    private final List<List<Body>> squares = new ArrayList<>();
    private final long[] movements;
    private double largestReachMm;

    BodyIndex(Bounds bounds) {
        this.bounds = bounds;
        columns = 1 + (int) ((bounds.maxX() - bounds.minX()) / SQUARE_MM);
        rows = 1 + (int) ((bounds.maxY() - bounds.minY()) / SQUARE_MM);
        for (int i = 0; i < columns * rows; i++) {
            squares.add(new ArrayList<>());
        }
        movements = new long[columns * rows];
    }

    void add(Body body) {
        int square = square(body.pose());
        squares.get(square).add(body);
        movements[square]++;
        largestReachMm = Math.max(largestReachMm, body.reachMm());
    }

    /** Reports that a body has moved. */
    void moved(Body body, Pose from) {
        int before = square(from);
        int now = square(body.pose());
        movements[before]++;
        if (now != before) {
            squares.get(before).remove(body);
            squares.get(now).add(body);
            movements[now]++;
        }
    }

    /** Adds all bodies on the floor of which a part may be within this distance; also some that are farther. */
    void near(double xMm, double yMm, double withinMm, List<Body> found) {
        double look = withinMm + largestReachMm;
        int lastRow = row(yMm + look);
        int lastColumn = column(xMm + look);
        for (int row = row(yMm - look); row <= lastRow; row++) {
            for (int column = column(xMm - look); column <= lastColumn; column++) {
                List<Body> square = squares.get(row * columns + column);
                for (int i = 0; i < square.size(); i++) {
                    Body body = square.get(i);
                    if (!body.isAloft() && body.mayReach(xMm, yMm, withinMm)) {
                        found.add(body);
                    }
                }
            }
        }
    }

    /**
     * Adds all bodies on the floor of which a part may be in the cone; also some that are not.
     *
     * @param around the bounds of the cone
     */
    void in(Bounds around, Cone cone, List<Body> found) {
        int lastRow = row(around.maxY() + largestReachMm);
        int lastColumn = column(around.maxX() + largestReachMm);
        for (int row = row(around.minY() - largestReachMm); row <= lastRow; row++) {
            for (int column = column(around.minX() - largestReachMm); column <= lastColumn; column++) {
                List<Body> square = squares.get(row * columns + column);
                for (int i = 0; i < square.size(); i++) {
                    Body body = square.get(i);
                    if (!body.isAloft() && cone.mayMeet(body)) {
                        found.add(body);
                    }
                }
            }
        }
    }

    /** A number that grows whenever a body moves of which a part is within this distance. */
    long movementsNear(double xMm, double yMm, double withinMm) {
        double look = withinMm + largestReachMm;
        int lastRow = row(yMm + look);
        int lastColumn = column(xMm + look);
        long sum = 0;
        for (int row = row(yMm - look); row <= lastRow; row++) {
            for (int column = column(xMm - look); column <= lastColumn; column++) {
                sum += movements[row * columns + column];
            }
        }
        return sum;
    }

    private int square(Pose pose) {
        return row(pose.yMm()) * columns + column(pose.xMm());
    }

    private int column(double x) {
        return Math.max(0, Math.min(columns - 1, (int) ((x - bounds.minX()) / SQUARE_MM)));
    }

    private int row(double y) {
        return Math.max(0, Math.min(rows - 1, (int) ((y - bounds.minY()) / SQUARE_MM)));
    }
}
