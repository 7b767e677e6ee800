package majic.nav.grid;

import java.util.Arrays;
import majic.bot.Pose;
import majic.nav.grid.OccupancyGrid.State;

/**
 * How likely an echo is at each place of a map: by its distance from the nearest occupied cell (Thrun, Burgard, Fox
 * 2005, 6.4). Immutable; takes a byte for each cell.
 */
public final class LikelihoodField {
    /** Distances are limited to this, mm: an echo farther from a wall is one of something that is not on the map. */
    public static final double FAR_MM = 400;

    /** Distances are kept in steps of this, mm. */
    private static final double STEP_MM = 4;

    private static final byte FAR = (byte) (FAR_MM / STEP_MM);
    private static final byte UNKNOWN = -1;

    private final OccupancyGrid grid;
    private final double cos;
    private final double sin;
    private final byte[] distance;

    /**
     * Computes the distances; takes about 10 ms for 1000 m².
     *
     * @param grid the map
     */
    public LikelihoodField(OccupancyGrid grid) {
        this.grid = grid;
        double angle = Math.toRadians(grid.origin().headingDeg());
        cos = Math.cos(angle);
        sin = Math.sin(angle);
        distance = new byte[grid.width() * grid.height()];
        Arrays.fill(distance, FAR);
        for (int row = 0; row < grid.height(); row++) {
            for (int column = 0; column < grid.width(); column++) {
                if (grid.state(column, row) == State.OCCUPIED) {
                    stamp(column, row);
                }
            }
        }
        for (int cell = 0; cell < distance.length; cell++) {
            if (distance[cell] == FAR && grid.state(cell % grid.width(), cell / grid.width()) == State.UNKNOWN) {
                distance[cell] = UNKNOWN;
            }
        }
    }

    private void stamp(int column, int row) {
        int far = (int) Math.ceil(FAR_MM / grid.cellMm());
        for (int y = Math.max(0, row - far); y <= Math.min(grid.height() - 1, row + far); y++) {
            for (int x = Math.max(0, column - far); x <= Math.min(grid.width() - 1, column + far); x++) {
                double mm = grid.cellMm() * Math.hypot(x - column, y - row);
                int cell = y * grid.width() + x;
                distance[cell] = (byte) Math.min(distance[cell], mm / STEP_MM);
            }
        }
    }

    /** Returns the map. */
    public OccupancyGrid grid() {
        return grid;
    }

    /**
     * Returns the distance from the nearest occupied cell.
     *
     * @param xMm in the frame of the map
     * @param yMm in the frame of the map
     * @return mm, at most {@link #FAR_MM}; not a number outside the map and far from walls in what is unknown, where an
     *     echo neither agrees nor disagrees with the map
     */
    public double distanceMm(double xMm, double yMm) {
        Pose origin = grid.origin();
        double dx = xMm - origin.xMm();
        double dy = yMm - origin.yMm();
        int column = (int) Math.floor((cos * dx + sin * dy) / grid.cellMm());
        int row = (int) Math.floor((cos * dy - sin * dx) / grid.cellMm());
        if (column < 0 || row < 0 || column >= grid.width() || row >= grid.height()) {
            return Double.NaN;
        }
        byte steps = distance[row * grid.width() + column];
        return steps == UNKNOWN ? Double.NaN : steps * STEP_MM;
    }
}
