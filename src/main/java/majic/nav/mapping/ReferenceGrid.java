package majic.nav.mapping;

import java.util.Arrays;
import java.util.List;
import majic.bot.Pose;

/**
 * The points of several scans at their places, which another scan is matched to: cells of {@value #CELL_MM} mm with the
 * nearest point, and with the likelihood of an echo there, also for blocks of cells of growing size.
 *
 * <p>The likelihood is that of the likelihood field (Thrun, Burgard, Fox 2005, 6.4) without its uniform part. The block
 * of level h at (i, j) has the maximum over the square of 2^(h+1) cells that begins at cell (i 2^h, j 2^h), so that it
 * bounds every placement of a point within 2^h cells (Olson 2009; Hess 2016, section V.B).
 */
final class ReferenceGrid {
    static final double CELL_MM = 50;

    /** The standard deviation of the likelihood: one and a half cells, so that neighbouring cells of a wall overlap. */
    private static final double SIGMA_MM = 75;

    /** Points farther away do not count. */
    private static final double FAR_MM = 200;

    private static final int FAR_CELLS = (int) (FAR_MM / CELL_MM);
    static final int FULL = 255;
    private static final byte[] LIKELIHOOD = likelihoods();

    /** A scan at its place. */
    record PlacedPoints(EchoPoints points, Pose pose) {}

    final double minX;
    final double minY;
    private final int width;
    private final int height;
    private final float[] squared;
    private final int[] nearest;
    private final EchoPoints points;
    private final byte[][] levels;

    /** Builds the grid with levels 0 to {@code highest}. */
    ReferenceGrid(List<PlacedPoints> scans, int highest) {
        points = EchoPoints.joined(scans, Pose.START);
        minX = least(points.x) - FAR_MM - CELL_MM;
        minY = least(points.y) - FAR_MM - CELL_MM;
        width = (int) ((greatest(points.x) - minX + FAR_MM) / CELL_MM) + 2;
        height = (int) ((greatest(points.y) - minY + FAR_MM) / CELL_MM) + 2;
        squared = new float[width * height];
        Arrays.fill(squared, (float) (FAR_MM * FAR_MM));
        nearest = new int[width * height];
        Arrays.fill(nearest, -1);
        for (int point = 0; point < points.count; point++) {
            stamp(point);
        }
        levels = new byte[highest + 1][];
        fillLevels();
    }

    private static double least(float[] values) {
        float least = values.length == 0 ? 0 : values[0];
        for (float value : values) {
            least = Math.min(least, value);
        }
        return least;
    }

    private static double greatest(float[] values) {
        float greatest = values.length == 0 ? 0 : values[0];
        for (float value : values) {
            greatest = Math.max(greatest, value);
        }
        return greatest;
    }

    private void stamp(int point) {
        int column = column(points.x[point]);
        int row = row(points.y[point]);
        for (int y = row - FAR_CELLS; y <= row + FAR_CELLS; y++) {
            double dy = minY + (y + 0.5) * CELL_MM - points.y[point];
            for (int x = column - FAR_CELLS; x <= column + FAR_CELLS; x++) {
                double dx = minX + (x + 0.5) * CELL_MM - points.x[point];
                float distance = (float) (dx * dx + dy * dy);
                int cell = y * width + x;
                if (distance < squared[cell]) {
                    squared[cell] = distance;
                    nearest[cell] = point;
                }
            }
        }
    }

    private static byte[] likelihoods() {
        byte[] table = new byte[(int) FAR_MM + 1];
        for (int mm = 0; mm < table.length - 1; mm++) {
            table[mm] = (byte) Math.round(FULL * Math.exp(-0.5 * mm * mm / (SIGMA_MM * SIGMA_MM)));
        }
        return table;
    }

    /** The plain maximum of each block of a level first, and from it the maximum over the block and its neighbours. */
    private void fillLevels() {
        byte[] own = new byte[width * height];
        for (int cell = 0; cell < own.length; cell++) {
            if (nearest[cell] >= 0) {
                own[cell] = LIKELIHOOD[(int) Math.sqrt(squared[cell])];
            }
        }
        levels[0] = own;
        byte[] block = own;
        for (int level = 1; level < levels.length; level++) {
            block = merged(block, columns(level - 1), rows(level - 1), columns(level), rows(level), 2);
            levels[level] = merged(block, columns(level), rows(level), columns(level), rows(level), 1);
        }
    }

    private static byte[] merged(byte[] from, int columns, int rows, int newColumns, int newRows, int step) {
        byte[] to = new byte[newColumns * newRows];
        for (int y = 0; y < newRows; y++) {
            int top = Math.min(y * step, rows - 1) * columns;
            int bottom = Math.min(y * step + 1, rows - 1) * columns;
            for (int x = 0; x < newColumns; x++) {
                int left = Math.min(x * step, columns - 1);
                int right = Math.min(x * step + 1, columns - 1);
                int most = Math.max(
                        Math.max(from[top + left] & FULL, from[top + right] & FULL),
                        Math.max(from[bottom + left] & FULL, from[bottom + right] & FULL));
                to[y * newColumns + x] = (byte) most;
            }
        }
        return to;
    }

    private int columns(int level) {
        return ((width - 1) >> level) + 1;
    }

    private int rows(int level) {
        return ((height - 1) >> level) + 1;
    }

    private int column(double x) {
        return (int) Math.floor((x - minX) / CELL_MM);
    }

    private int row(double y) {
        return (int) Math.floor((y - minY) / CELL_MM);
    }

    int highestLevel() {
        return levels.length - 1;
    }

    /**
     * Sums the likelihoods of points that are displaced by a number of cells.
     *
     * @param columns the points' columns, from {@code minX}; any
     * @param level 0 for the cells themselves, else an upper bound for displacements up to 2^level − 1 more
     */
    int sum(int[] columns, int[] rows, int count, int right, int up, int level) {
        byte[] values = levels[level];
        int most = columns(level);
        int mostRows = rows(level);
        int sum = 0;
        for (int index = 0; index < count; index++) {
            int x = (columns[index] + right) >> level;
            int y = (rows[index] + up) >> level;
            // The block at -1 reaches into block 0, which bounds it.
            if (x >= -1 && y >= -1 && x < most && y < mostRows) {
                sum += values[Math.max(y, 0) * most + Math.max(x, 0)] & FULL;
            }
        }
        return sum;
    }

    /** The index of the point nearest to a place, or −1 if there is none within 200 mm. */
    int nearest(double x, double y) {
        int column = column(x);
        int row = row(y);
        return column < 0 || row < 0 || column >= width || row >= height ? -1 : nearest[row * width + column];
    }

    /** All points, in the frame of the reference. */
    EchoPoints points() {
        return points;
    }
}
