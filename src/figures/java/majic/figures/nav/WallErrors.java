package majic.figures.nav;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import majic.bot.Pose;
import majic.lab.LabAccess.Wall;
import majic.nav.grid.OccupancyGrid;
import majic.nav.grid.OccupancyGrid.State;

/** How far the occupied cells of a map are from the true walls; those where another robot was do not count. */
final class WallErrors {
    private static final double ROBOT_MM = 300;
    private static final double RIGHT_MM = 50;

    private final List<Wall> walls;
    private final List<Pose> others;
    private final List<Double> errors = new ArrayList<>();

    WallErrors(OccupancyGrid map, List<Wall> walls, List<Pose> others) {
        this.walls = walls;
        this.others = others;
        for (int row = 0; row < map.height(); row++) {
            for (int column = 0; column < map.width(); column++) {
                if (map.state(column, row) == State.OCCUPIED) {
                    add(map.centre(column, row));
                }
            }
        }
        errors.sort(null);
    }

    private void add(Pose cell) {
        if (others.stream().noneMatch(other -> other.distanceMm(cell) < ROBOT_MM)) {
            errors.add(walls.stream()
                    .mapToDouble(wall -> distance(wall, cell))
                    .min()
                    .orElseThrow());
        }
    }

    private static double distance(Wall wall, Pose cell) {
        double x = wall.x2() - wall.x1();
        double y = wall.y2() - wall.y1();
        double along = ((cell.xMm() - wall.x1()) * x + (cell.yMm() - wall.y1()) * y) / (x * x + y * y);
        double at = Math.max(0, Math.min(1, along));
        return Math.hypot(cell.xMm() - wall.x1() - at * x, cell.yMm() - wall.y1() - at * y);
    }

    /** Returns the share of the cells that are right, and the errors. */
    String text() {
        long right = errors.stream().filter(mm -> mm <= RIGHT_MM).count();
        return String.format(
                Locale.ROOT,
                "%d occupied cells: %.1f %% within 50 mm of a true wall, median %.0f mm, 95 of 100 within %.0f mm"
                        + " (at most 50), worst %.0f mm",
                errors.size(),
                100.0 * right / errors.size(),
                errors.get(errors.size() / 2),
                errors.get(errors.size() * 95 / 100),
                errors.get(errors.size() - 1));
    }
}
