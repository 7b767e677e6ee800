package majic.nav.path;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicReference;
import majic.nav.grid.OccupancyGrid;
import majic.nav.grid.OccupancyGrid.State;
import org.jspecify.annotations.Nullable;

/**
 * The nodes of a search across a map for robots of one radius, and what a millimetre costs at each: computed once for
 * all plans, with which nodes are connected. A border of one node around the map ends each search. Thread-safe.
 */
final class PlanNodes {
    /** The robot does not fit there, or nothing is known. */
    static final byte CLOSED = 0;

    /** Outside of the map. */
    static final byte BORDER = -1;

    private static final int STEPS_OF_PRICE = 100;

    final int cells;
    final int columns;
    final int rows;

    /** The difference of the indices of a node and of the one above it. */
    final int stride;

    private final double bodyMm;
    private final double comfortMm;
    private final byte[] prices;

    /** The part of the map, connected on its own, to which each open node belongs; 0 for the others. */
    private final short[] parts;

    private final AtomicReference<@Nullable Workspace> spare = new AtomicReference<>();

    /** The arrays of one search. */
    static final class Workspace {
        final float[] cost;
        final byte[] came;

        private Workspace(int nodes) {
            cost = new float[nodes];
            came = new byte[nodes];
        }
    }

    /**
     * Computes the prices.
     *
     * @param cells the cells of a node, in each direction
     * @param comfortMm with less room than this, a millimetre costs up to twice as much
     */
    PlanNodes(ObstacleDistance map, int cells, double bodyMm, double comfortMm) {
        OccupancyGrid grid = map.grid();
        this.cells = cells;
        this.bodyMm = bodyMm;
        this.comfortMm = comfortMm;
        columns = (grid.width() + cells - 1) / cells;
        rows = (grid.height() + cells - 1) / cells;
        stride = columns + 2;
        prices = new byte[stride * (rows + 2)];
        Arrays.fill(prices, BORDER);
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                int x = middle(column, grid.width());
                int y = middle(row, grid.height());
                double price = grid.state(x, y) == State.UNKNOWN
                        ? Double.POSITIVE_INFINITY
                        : price(map.mmOfCell(x, y) - grid.cellMm() / 2 - bodyMm, comfortMm);
                prices[node(column, row)] =
                        price == Double.POSITIVE_INFINITY ? CLOSED : (byte) Math.round(price * STEPS_OF_PRICE);
            }
        }
        parts = parts();
    }

    private short[] parts() {
        short[] part = new short[prices.length];
        int[] open = new int[prices.length];
        short found = 0;
        for (int first = 0; first < part.length; first++) {
            if (!isOpen(first) || part[first] != 0) {
                continue;
            }
            // Those beyond the largest number count as one, which only costs a search.
            found = (short) Math.min(found + 1, Short.MAX_VALUE);
            part[first] = found;
            open[0] = first;
            for (int left = 1; left > 0; ) {
                left--;
                int node = open[left];
                for (int up = -stride; up <= stride; up += stride) {
                    for (int next = node + up - 1; next <= node + up + 1; next++) {
                        if (isOpen(next) && part[next] == 0) {
                            part[next] = found;
                            open[left] = next;
                            left++;
                        }
                    }
                }
            }
        }
        return part;
    }

    private boolean isOpen(int node) {
        return prices[node] != CLOSED && prices[node] != BORDER;
    }

    /**
     * Returns whether a way may lead from one node to another one, as far as the map is concerned.
     *
     * @param aroundFrom how many nodes around the first one the robot may cross though it does not fit there
     */
    boolean mayReach(int from, int aroundFrom, int to) {
        for (int row = Math.max(0, row(from) - aroundFrom); row <= Math.min(rows - 1, row(from) + aroundFrom); row++) {
            int most = Math.min(columns - 1, column(from) + aroundFrom);
            for (int column = Math.max(0, column(from) - aroundFrom); column <= most; column++) {
                int near = node(column, row);
                if (Math.abs(column - column(to)) <= 1 && Math.abs(row - row(to)) <= 1
                        || parts[near] != 0 && touches(to, parts[near])) {
                    return true;
                }
            }
        }
        return false;
    }

    private boolean touches(int node, short part) {
        for (int up = -stride; up <= stride; up += stride) {
            for (int next = node + up - 1; next <= node + up + 1; next++) {
                if (parts[next] == part) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Returns what a millimetre costs with some room: 1 to 2, infinite where the robot does not fit. */
    static double price(double roomMm, double comfortMm) {
        if (roomMm < FreeSpace.MARGIN_MM) {
            return Double.POSITIVE_INFINITY;
        }
        return roomMm >= comfortMm ? 1 : 1 + (comfortMm - roomMm) / comfortMm;
    }

    boolean isFor(int itsCells, double itsBodyMm, double itsComfortMm) {
        return cells == itsCells && bodyMm == itsBodyMm && comfortMm == itsComfortMm;
    }

    /** Returns the number of nodes, with those of the border. */
    int count() {
        return prices.length;
    }

    int node(int column, int row) {
        return (row + 1) * stride + column + 1;
    }

    int column(int node) {
        return node % stride - 1;
    }

    int row(int node) {
        return node / stride - 1;
    }

    /** Returns the cell in the middle of a node, in one direction. */
    int middle(int index, int most) {
        return Math.min(index * cells + cells / 2, most - 1);
    }

    /** Returns {@link #CLOSED}, {@link #BORDER}, or what {@link #price(byte)} turns into a price. */
    byte code(int node) {
        return prices[node];
    }

    static float price(byte code) {
        return (code & 0xFF) * (1f / STEPS_OF_PRICE);
    }

    /** Returns arrays for a search, as the last one left them. */
    Workspace take() {
        Workspace kept = spare.getAndSet(null);
        return kept == null ? new Workspace(count()) : kept;
    }

    /** Keeps the arrays for the next search, unless they are those of the rare search from cell to cell. */
    void giveBack(Workspace arrays) {
        if (cells > 1) {
            spare.set(arrays);
        }
    }
}
