package majic.nav.path;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import majic.bot.Pose;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.NavigationMap.ForbiddenLine;
import majic.nav.grid.OccupancyGrid;
import majic.nav.grid.OccupancyGrid.State;

/**
 * How far each cell of a map is from the nearest obstacle: an occupied cell or a forbidden line (exact Euclidean
 * distances; Felzenszwalb and Huttenlocher 2012). Immutable; takes two bytes for each cell, and further ones for robots
 * that plan ways.
 */
public final class ObstacleDistance {
    private static final int FAR = Short.MAX_VALUE;

    /** For robots of so many radii, alone and in traffic, the nodes of a search are kept. */
    private static final int MOST_NODES = 8;

    private final OccupancyGrid grid;
    private final double cos;
    private final double sin;
    private final short[] millimetres;

    /** Those used last at the end. */
    private final List<PlanNodes> nodes = new ArrayList<>();

    /**
     * Computes the distances; takes about 50 ns for each cell.
     *
     * @param map the map
     */
    public ObstacleDistance(NavigationMap map) {
        grid = map.grid();
        double angle = Math.toRadians(grid.origin().headingDeg());
        cos = Math.cos(angle);
        sin = Math.sin(angle);
        boolean[] obstacle = new boolean[grid.width() * grid.height()];
        for (int row = 0; row < grid.height(); row++) {
            for (int column = 0; column < grid.width(); column++) {
                obstacle[row * grid.width() + column] = grid.state(column, row) == State.OCCUPIED;
            }
        }
        map.forbidden().forEach(line -> draw(line, obstacle));
        millimetres = distances(obstacle);
    }

    private void draw(ForbiddenLine line, boolean[] obstacle) {
        double length = Math.hypot(line.toXmm() - line.fromXmm(), line.toYmm() - line.fromYmm());
        int steps = (int) Math.ceil(2 * length / grid.cellMm()) + 1;
        for (int step = 0; step <= steps; step++) {
            double share = (double) step / steps;
            int cell = cell(
                    line.fromXmm() + share * (line.toXmm() - line.fromXmm()),
                    line.fromYmm() + share * (line.toYmm() - line.fromYmm()));
            if (cell >= 0) {
                obstacle[cell] = true;
            }
        }
    }

    /** The columns first, then the rows over the squares of the columns' distances. */
    private short[] distances(boolean[] obstacle) {
        int width = grid.width();
        int height = grid.height();
        float[] square = new float[width * height];
        int longest = Math.max(width, height);
        Parabolas line = new Parabolas(longest);
        double[] values = new double[longest];
        for (int column = 0; column < width; column++) {
            for (int row = 0; row < height; row++) {
                values[row] = obstacle[row * width + column] ? 0 : Parabolas.NONE;
            }
            line.transform(values, height);
            for (int row = 0; row < height; row++) {
                square[row * width + column] = (float) line.distance(row);
            }
        }
        short[] distance = new short[width * height];
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                values[column] = square[row * width + column];
            }
            line.transform(values, width);
            for (int column = 0; column < width; column++) {
                double cells = Math.sqrt(line.distance(column));
                distance[row * width + column] = (short) Math.min(FAR, grid.cellMm() * cells);
            }
        }
        return distance;
    }

    /** The lower envelope of the parabolas of one row or column. */
    private static final class Parabolas {
        static final double NONE = 1e12;

        private final int[] site;
        private final double[] from;
        private final double[] result;

        Parabolas(int longest) {
            site = new int[longest];
            from = new double[longest + 1];
            result = new double[longest];
        }

        void transform(double[] values, int count) {
            int last = -1;
            for (int at = 0; at < count; at++) {
                if (values[at] >= NONE / 2) {
                    continue;
                }
                double begin = Double.NEGATIVE_INFINITY;
                while (last >= 0) {
                    int other = site[last];
                    begin = (values[at] + (double) at * at - values[other] - (double) other * other)
                            / (2.0 * (at - other));
                    if (begin > from[last]) {
                        break;
                    }
                    last--;
                    begin = Double.NEGATIVE_INFINITY;
                }
                last++;
                site[last] = at;
                from[last] = begin;
            }
            if (last < 0) {
                Arrays.fill(result, 0, count, NONE);
                return;
            }
            from[last + 1] = Double.POSITIVE_INFINITY;
            int nearest = 0;
            for (int at = 0; at < count; at++) {
                while (from[nearest + 1] < at) {
                    nearest++;
                }
                double away = at - site[nearest];
                result[at] = away * away + values[site[nearest]];
            }
        }

        double distance(int at) {
            return result[at];
        }
    }

    /** Returns the map's grid. */
    public OccupancyGrid grid() {
        return grid;
    }

    /** Returns the index of the cell at a place; -1 outside of the grid. */
    private int cell(double xMm, double yMm) {
        Pose origin = grid.origin();
        double dx = xMm - origin.xMm();
        double dy = yMm - origin.yMm();
        int column = (int) Math.floor((cos * dx + sin * dy) / grid.cellMm());
        int row = (int) Math.floor((cos * dy - sin * dx) / grid.cellMm());
        return column < 0 || row < 0 || column >= grid.width() || row >= grid.height()
                ? -1
                : row * grid.width() + column;
    }

    /**
     * Returns the distance of a place from the nearest obstacle of the map.
     *
     * @param xMm in the frame of the map
     * @param yMm in the frame of the map
     * @return mm, from centre to centre of the cells; infinite outside of the grid and without an obstacle
     */
    public double mm(double xMm, double yMm) {
        int cell = cell(xMm, yMm);
        return cell < 0 || millimetres[cell] == FAR ? Double.POSITIVE_INFINITY : millimetres[cell];
    }

    /** Returns the distance of a cell as {@link #mm} does. */
    double mmOfCell(int column, int row) {
        return millimetres[row * grid.width() + column];
    }

    /** Returns the nodes of a search for robots of a radius, made by the first one. */
    PlanNodes nodes(int cells, double bodyMm, double comfortMm) {
        synchronized (nodes) {
            PlanNodes found = nodes.stream()
                    .filter(kept -> kept.isFor(cells, bodyMm, comfortMm))
                    .findFirst()
                    .orElseGet(() -> new PlanNodes(this, cells, bodyMm, comfortMm));
            nodes.remove(found);
            nodes.add(found);
            if (nodes.size() > MOST_NODES) {
                nodes.remove(0);
            }
            return found;
        }
    }

    /**
     * Returns whether anything is known of a place.
     *
     * @param xMm in the frame of the map
     * @param yMm in the frame of the map
     * @return whether its cell is free or occupied
     */
    public boolean isKnown(double xMm, double yMm) {
        int cell = cell(xMm, yMm);
        return cell >= 0 && grid.state(cell % grid.width(), cell / grid.width()) != State.UNKNOWN;
    }
}
