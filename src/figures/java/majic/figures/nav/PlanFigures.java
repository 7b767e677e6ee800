package majic.figures.nav;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import majic.bot.Pose;
import majic.figures.Measurement;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.OccupancyGrid;
import majic.nav.path.FreeSpace;
import majic.nav.path.ObstacleDistance;
import majic.nav.path.PathPlanner;
import majic.nav.path.Way;

/**
 * Plans ways across a building of 100 m by 100 m in 2000 by 2000 cells: rooms of 5 m on both sides of corridors, with
 * furniture. The time of a plan, ms of processor time and of the clock on the wall, as median, the value that 95 of 100
 * do not exceed, and the largest.
 */
public final class PlanFigures {
    private static final int CELLS = 2000;
    private static final double CELL_MM = 50;
    private static final int ROOM = 100;
    private static final int CORRIDOR = 44;
    private static final int WALL = 4;
    private static final int DOOR = 22;
    private static final int PIECES_OF_FURNITURE = 1600;
    private static final double FREE = 0.02;
    private static final double OCCUPIED = 0.98;
    private static final double BODY_MM = 300;
    private static final double ROOM_MM = 80;
    private static final int WARM_UP = 40;

    private final Random random;
    private final boolean[] occupied = new boolean[CELLS * CELLS];
    private final FreeSpace space;

    /**
     * Builds it.
     *
     * @param seed of the doors, the furniture and the places
     */
    public PlanFigures(long seed) {
        random = new Random(seed);
        int band = 2 * ROOM + CORRIDOR;
        for (int low = 0; low < CELLS; low += band) {
            rooms(low, low + ROOM);
            rooms(low + ROOM + CORRIDOR, low + band);
        }
        // Passages between the corridors, at both ends and in the middle.
        for (int column : new int[] {10, CELLS / 2, CELLS - 10 - CORRIDOR}) {
            fill(column, WALL, CORRIDOR, CELLS - 2 * WALL, false);
        }
        for (int piece = 0; piece < PIECES_OF_FURNITURE; piece++) {
            fill(random.nextInt(CELLS), random.nextInt(CELLS), 6 + random.nextInt(16), 6 + random.nextInt(16), true);
        }
        fill(0, 0, CELLS, WALL, true);
        fill(0, CELLS - WALL, CELLS, WALL, true);
        fill(0, 0, WALL, CELLS, true);
        fill(CELLS - WALL, 0, WALL, CELLS, true);
        space = new FreeSpace(
                new ObstacleDistance(NavigationMap.of(OccupancyGrid.of(
                        Pose.START,
                        CELL_MM,
                        CELLS,
                        CELLS,
                        (column, row) -> occupied[row * CELLS + column] ? OCCUPIED : FREE))),
                BODY_MM,
                List.of());
    }

    /** A row of rooms, with a door to the corridor and most with one to the next room. */
    private void rooms(int low, int high) {
        fill(0, low, CELLS, WALL, true);
        fill(0, high - WALL, CELLS, WALL, true);
        for (int left = 0; left < CELLS; left += ROOM) {
            fill(left, low, WALL, high - low, true);
            fill(left + 10 + random.nextInt(ROOM - DOOR - 20), low, DOOR, WALL, false);
            fill(left + 10 + random.nextInt(ROOM - DOOR - 20), high - WALL, DOOR, WALL, false);
            if (random.nextInt(3) > 0) {
                fill(left, low + 10 + random.nextInt(ROOM - DOOR - 20), WALL, DOOR, false);
            }
        }
    }

    private void fill(int left, int low, int width, int height, boolean value) {
        for (int row = low; row < Math.min(CELLS, low + height); row++) {
            for (int column = left; column < Math.min(CELLS, left + width); column++) {
                occupied[row * CELLS + column] = value;
            }
        }
    }

    private Pose place() {
        while (true) {
            Pose place = new Pose(random.nextDouble() * CELLS * CELL_MM, random.nextDouble() * CELLS * CELL_MM, 0);
            if (space.mm(place.xMm(), place.yMm()) > ROOM_MM) {
                return place;
            }
        }
    }

    /**
     * Plans ways between random places.
     *
     * @return for each, ms of processor time, ms of the clock, mm; 0 mm where there is none
     */
    public List<double[]> plan(int ways) {
        List<double[]> rows = new ArrayList<>();
        for (int way = 0; way < ways; way++) {
            Pose from = place();
            Pose to = place();
            long beganNanos = System.nanoTime();
            long beganCpu = ReactionProbe.cpuNanos();
            Optional<Way> found = new PathPlanner(space).plan(from, to);
            rows.add(new double[] {
                (ReactionProbe.cpuNanos() - beganCpu) / 1e6,
                (System.nanoTime() - beganNanos) / 1e6,
                found.map(Way::lengthMm).orElse(0.0)
            });
        }
        return rows;
    }

    private static String spread(List<double[]> rows, int index) {
        return GoToFigures.spread(rows.stream().map(row -> row[index]).toList());
    }

    /** Plans a number of ways, with a seed. */
    public static void main(String[] arguments) {
        Measurement.run(() -> {
            PlanFigures figures = new PlanFigures(Long.parseLong(arguments[1]));
            figures.plan(WARM_UP);
            List<double[]> rows = figures.plan(Integer.parseInt(arguments[0]));
            return List.of(String.format(
                    Locale.ROOT,
                    "| %d ways, %d found | %s | %s |",
                    rows.size(),
                    rows.stream().filter(row -> row[2] > 0).count(),
                    spread(rows, 0),
                    spread(rows, 1)));
        });
    }
}
