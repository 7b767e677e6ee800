package majicsim.world;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntConsumer;

/** Lists for each square of the floor the walls near it, so that a ray or a body is compared with few walls only. */
final class WallIndex {
    private static final int MOST_CELLS_A_SIDE = 200;

    private final Bounds bounds;
    private final double cellMm;
    private final int columns;
    private final int rows;
    private final int[][] cells;

    WallIndex(List<Segment> walls, Bounds bounds, double leastCellMm) {
        this.bounds = bounds;
        double side = Math.max(bounds.maxX() - bounds.minX(), bounds.maxY() - bounds.minY());
        cellMm = Math.max(leastCellMm, side / MOST_CELLS_A_SIDE);
        columns = 1 + (int) ((bounds.maxX() - bounds.minX()) / cellMm);
        rows = 1 + (int) ((bounds.maxY() - bounds.minY()) / cellMm);
        List<List<Integer>> found = new ArrayList<>();
        for (int i = 0; i < columns * rows; i++) {
            found.add(new ArrayList<>());
        }
        for (int i = 0; i < walls.size(); i++) {
            enter(i, walls.get(i), found);
        }
        cells = found.stream()
                .map(cell -> cell.stream().mapToInt(Integer::intValue).toArray())
                .toArray(int[][]::new);
    }

    double cellMm() {
        return cellMm;
    }

    /** Passes on the numbers of all walls that may touch the rectangle; also some that do not, and some twice. */
    void near(double minX, double minY, double maxX, double maxY, IntConsumer visitor) {
        int lastRow = row(maxY);
        int lastColumn = column(maxX);
        for (int row = row(minY); row <= lastRow; row++) {
            for (int column = column(minX); column <= lastColumn; column++) {
                for (int wall : cells[row * columns + column]) {
                    visitor.accept(wall);
                }
            }
        }
    }

    private void enter(int number, Segment wall, List<List<Integer>> found) {
        for (int row = row(Math.min(wall.y1(), wall.y2())); row <= row(Math.max(wall.y1(), wall.y2())); row++) {
            int last = column(Math.max(wall.x1(), wall.x2()));
            for (int column = column(Math.min(wall.x1(), wall.x2())); column <= last; column++) {
                found.get(row * columns + column).add(number);
            }
        }
    }

    private int column(double x) {
        return Math.max(0, Math.min(columns - 1, (int) ((x - bounds.minX()) / cellMm)));
    }

    private int row(double y) {
        return Math.max(0, Math.min(rows - 1, (int) ((y - bounds.minY()) / cellMm)));
    }
}
