package majic.nav.grid;

import java.util.Arrays;
import java.util.List;
import majic.bot.Beam;
import majic.bot.Pose;
import majic.bot.RangeScan;

/**
 * Draws scans into a grid that grows with them: cells in front of an echo become less likely to be occupied, those at
 * it more likely (log-odds with the inverse sensor model of Thrun, Burgard, Fox 2005, 9.2). A beam without an echo says
 * nothing, since a black or smooth surface gives none either. Not thread-safe.
 */
public final class GridBuilder {
    /** The size of a cell, mm. */
    public static final double CELL_MM = 50;

    /** The most cells in each direction, 204.8 m; what lies outside is left out. */
    public static final int MOST_CELLS = 4096;

    /** Echoes farther away are not drawn: there, an error of the heading of half a degree is five cells. */
    private static final double REACH_MM = 30_000;

    /** Hit 0.7, miss 0.4, limits 0.12 and 0.97: those of OctoMap (Hornung 2013, section 5.1). */
    private static final int HIT = OccupancyGrid.logOdds(0.7);

    private static final int MISS = OccupancyGrid.logOdds(0.4);
    private static final int LEAST = OccupancyGrid.logOdds(0.12);
    private static final int MOST = OccupancyGrid.logOdds(0.97);

    private static final int GROWTH = 128;

    private int left;
    private int low;
    private int width;
    private int height;
    private byte[] cells = new byte[0];

    /**
     * Draws a scan.
     *
     * @param scan what was measured
     * @param pose the pose of the robot's centre, in the frame of the grid
     */
    public void add(RangeScan scan, Pose pose) {
        List<Beam> beams = scan.sensor().beams();
        for (int index = 0; index < scan.size(); index++) {
            float range = scan.rangeMm(index);
            if (range < REACH_MM) {
                add(beams.get(index), range, pose);
            }
        }
    }

    /** A wide beam is drawn as rays whose ends are a cell apart: all are free, and one of them has the echo. */
    private void add(Beam beam, float range, Pose pose) {
        Pose mount = pose.plus(beam.mount());
        double arc = Math.toRadians(beam.openingDeg()) * range;
        int rays = Math.max(1, beam.openingDeg() > 1 ? (int) (arc / CELL_MM) : 1);
        int hit = Math.max(1, HIT / rays);
        for (int ray = 0; ray < rays; ray++) {
            double angle = Math.toRadians(mount.headingDeg() + beam.openingDeg() * ((ray + 0.5) / rays - 0.5));
            draw(mount, mount.xMm() + range * Math.cos(angle), mount.yMm() + range * Math.sin(angle), hit);
        }
    }

    /** The cells of a line, each once (Bresenham 1965). */
    private void draw(Pose from, double toX, double toY, int hit) {
        int x = cell(from.xMm());
        int y = cell(from.yMm());
        int endX = cell(toX);
        int endY = cell(toY);
        if (!include(x, y) || !include(endX, endY)) {
            return;
        }
        int dx = Math.abs(endX - x);
        int dy = -Math.abs(endY - y);
        int error = dx + dy;
        while (x != endX || y != endY) {
            change(x, y, MISS);
            int twice = 2 * error;
            if (twice >= dy) {
                error += dy;
                x += endX > x ? 1 : -1;
            }
            if (twice <= dx) {
                error += dx;
                y += endY > y ? 1 : -1;
            }
        }
        change(x, y, hit);
    }

    private static int cell(double mm) {
        return (int) Math.floor(mm / CELL_MM);
    }

    private void change(int x, int y, int by) {
        int cell = (y - low) * width + x - left;
        int old = cells[cell] == OccupancyGrid.UNKNOWN ? 0 : cells[cell];
        cells[cell] = (byte) Math.max(LEAST, Math.min(MOST, old + by));
    }

    /** Grows so that a cell is inside; returns false beyond the limit. */
    private boolean include(int x, int y) {
        if (width == 0) {
            left = x;
            low = y;
        } else if (x >= left && y >= low && x < left + width && y < low + height) {
            return true;
        }
        int newLeft = x < left ? x - GROWTH : left;
        int newLow = y < low ? y - GROWTH : low;
        int newWidth = Math.max(left + width, x >= left + width ? x + GROWTH : 0) - newLeft;
        int newHeight = Math.max(low + height, y >= low + height ? y + GROWTH : 0) - newLow;
        if (newWidth > MOST_CELLS || newHeight > MOST_CELLS) {
            return false;
        }
        byte[] grown = new byte[newWidth * newHeight];
        Arrays.fill(grown, OccupancyGrid.UNKNOWN);
        for (int row = 0; row < height; row++) {
            System.arraycopy(cells, row * width, grown, (row + low - newLow) * newWidth + left - newLeft, width);
        }
        cells = grown;
        left = newLeft;
        low = newLow;
        width = newWidth;
        height = newHeight;
        return true;
    }

    /** Returns what has been drawn, cut to the cells that something is known of; one unknown cell if there are none. */
    public OccupancyGrid toGrid() {
        int fromX = width;
        int toX = -1;
        int fromY = height;
        int toY = -1;
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                if (cells[y * width + x] != OccupancyGrid.UNKNOWN) {
                    fromX = Math.min(fromX, x);
                    toX = Math.max(toX, x);
                    fromY = Math.min(fromY, y);
                    toY = y;
                }
            }
        }
        if (toX < 0) {
            return new OccupancyGrid(Pose.START, CELL_MM, 1, 1, new byte[] {OccupancyGrid.UNKNOWN});
        }
        int columns = toX - fromX + 1;
        byte[] known = new byte[columns * (toY - fromY + 1)];
        for (int y = fromY; y <= toY; y++) {
            System.arraycopy(cells, y * width + fromX, known, (y - fromY) * columns, columns);
        }
        Pose origin = new Pose((left + fromX) * CELL_MM, (low + fromY) * CELL_MM, 0);
        return new OccupancyGrid(origin, CELL_MM, columns, toY - fromY + 1, known);
    }
}
