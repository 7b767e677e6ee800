package majic.nav.grid;

import majic.bot.Pose;

/**
 * A map of square cells, each with the probability that it is occupied (Moravec and Elfes 1985). Immutable.
 *
 * <p>Column 0 and row 0 are at the origin, the lower left corner; columns grow along its x axis and rows along its y
 * axis.
 */
public final class OccupancyGrid {
    /** The most cells: 67 million, 64 MB, such as 400 m by 400 m. */
    public static final int MOST_CELLS = 1 << 26;

    /** From this probability on, a cell is occupied; the default of map_server. */
    public static final double OCCUPIED = 0.65;

    /** Below this probability, a cell is free; the default of map_server. */
    public static final double FREE = 0.196;

    /** A cell nothing is known of. */
    static final byte UNKNOWN = Byte.MIN_VALUE;

    /** Log-odds are kept in steps of 1/32: from -3.97 to 3.97, which are the probabilities 0.019 and 0.981. */
    private static final double STEPS = 32;

    private static final double[] PROBABILITY = probabilities();

    private final Pose origin;
    private final double cellMm;
    private final int width;
    private final int height;
    private final byte[] cells;

    /** What is known of a cell. */
    public enum State {
        /** A robot can be there. */
        FREE,
        /** There is a wall or an object. */
        OCCUPIED,
        /** Nothing has been measured there, or as often free as occupied. */
        UNKNOWN
    }

    /** Keeps the array. */
    OccupancyGrid(Pose origin, double cellMm, int width, int height, byte[] cells) {
        this.origin = origin;
        this.cellMm = cellMm;
        this.width = width;
        this.height = height;
        this.cells = cells;
    }

    /** The probability of each cell, such as that of a picture. */
    @FunctionalInterface
    public interface Cells {
        /**
         * Returns the probability that a cell is occupied.
         *
         * @return 0 to 1, or not a number if nothing is known
         */
        double probability(int column, int row);
    }

    /**
     * Returns whether all cells within a distance of a place are known to be free.
     *
     * @param xMm of the place
     * @param yMm of the place
     * @param radiusMm the distance, 0 or more
     * @return false if one is occupied, unknown or outside of the grid
     */
    public boolean isFree(double xMm, double yMm, double radiusMm) {
        int cells = (int) Math.ceil(radiusMm / cellMm);
        for (int up = -cells; up <= cells; up++) {
            for (int right = -cells; right <= cells; right++) {
                double x = right * cellMm;
                double y = up * cellMm;
                if (Math.hypot(x, y) <= radiusMm && stateAt(xMm + x, yMm + y) != State.FREE) {
                    return false;
                }
            }
        }
        return true;
    }

    /**
     * Returns the distance from a place to the nearest occupied cell.
     *
     * @param xMm of the place
     * @param yMm of the place
     * @param mostMm farther ones are not looked for
     * @return mm, with the precision of a cell; infinite if there is none
     */
    public double obstacleMm(double xMm, double yMm, double mostMm) {
        int cells = (int) Math.ceil(mostMm / cellMm);
        double nearest = Double.POSITIVE_INFINITY;
        for (int ring = 0; ring <= cells && ring * cellMm <= Math.min(nearest, mostMm); ring++) {
            for (int along = -ring; along <= ring; along++) {
                nearest = Math.min(nearest, occupiedMm(xMm, yMm, along, ring));
                nearest = Math.min(nearest, occupiedMm(xMm, yMm, along, -ring));
                nearest = Math.min(nearest, occupiedMm(xMm, yMm, ring, along));
                nearest = Math.min(nearest, occupiedMm(xMm, yMm, -ring, along));
            }
        }
        return nearest <= mostMm ? nearest : Double.POSITIVE_INFINITY;
    }

    private double occupiedMm(double xMm, double yMm, int right, int up) {
        boolean occupied = stateAt(xMm + right * cellMm, yMm + up * cellMm) == State.OCCUPIED;
        return occupied ? Math.hypot(right, up) * cellMm : Double.POSITIVE_INFINITY;
    }

    /**
     * Makes a grid.
     *
     * @param origin the place of the lower left corner, and the direction of the columns
     * @param cellMm the size of a cell, mm, more than 0
     * @param width in cells, 1 or more
     * @param height in cells, 1 or more; width times height at most {@value #MOST_CELLS}
     * @param probabilities asked once for each cell
     * @return the grid
     * @throws IllegalArgumentException for a size outside these limits
     */
    public static OccupancyGrid of(Pose origin, double cellMm, int width, int height, Cells probabilities) {
        if (width < 1 || height < 1 || (long) width * height > MOST_CELLS || !(cellMm > 0)) {
            throw new IllegalArgumentException(
                    "a grid has 1 to " + MOST_CELLS + " cells of more than 0 mm, not " + width + " by " + height);
        }
        byte[] cells = new byte[width * height];
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                double probability = probabilities.probability(column, row);
                cells[row * width + column] = Double.isNaN(probability) ? UNKNOWN : (byte) logOdds(probability);
            }
        }
        return new OccupancyGrid(origin, cellMm, width, height, cells);
    }

    private static double[] probabilities() {
        double[] table = new double[256];
        for (int index = 0; index < table.length; index++) {
            table[index] = 1 / (1 + Math.exp(-(byte) index / STEPS));
        }
        table[UNKNOWN & 0xFF] = Double.NaN;
        return table;
    }

    /** The logarithm of the odds in steps, limited to what a byte holds beside {@link #UNKNOWN}. */
    static int logOdds(double probability) {
        double steps = STEPS * Math.log(probability / (1 - probability));
        return (int) Math.round(Math.max(-Byte.MAX_VALUE, Math.min(Byte.MAX_VALUE, steps)));
    }

    /**
     * Returns the same grid in another frame.
     *
     * @param frame the frame of this grid, seen from the other one
     * @return the grid; it shares the cells
     */
    public OccupancyGrid movedInto(Pose frame) {
        return new OccupancyGrid(frame.plus(origin), cellMm, width, height, cells);
    }

    /**
     * Returns this grid with what another one knows as well: the evidence of both is added.
     *
     * @param other in the same frame, whatever its origin and the size of its cells
     * @return a grid with the cells of this one that covers both; this one if that would have more than
     *     {@value #MOST_CELLS} cells
     */
    public OccupancyGrid joined(OccupancyGrid other) {
        double left = 0;
        double low = 0;
        double right = width;
        double top = height;
        for (int corner = 0; corner < 4; corner++) {
            Pose at = other.corner(corner % 2 * other.width, corner / 2 * other.height)
                    .seenFrom(origin);
            left = Math.min(left, Math.floor(at.xMm() / cellMm));
            low = Math.min(low, Math.floor(at.yMm() / cellMm));
            right = Math.max(right, Math.ceil(at.xMm() / cellMm));
            top = Math.max(top, Math.ceil(at.yMm() / cellMm));
        }
        if ((right - left) * (top - low) > MOST_CELLS) {
            return this;
        }
        int columns = (int) (right - left);
        int rows = (int) (top - low);
        byte[] both = new byte[columns * rows];
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                int ownColumn = column + (int) left;
                int ownRow = row + (int) low;
                both[row * columns + column] = added(cell(ownColumn, ownRow), other.cellAt(centre(ownColumn, ownRow)));
            }
        }
        return new OccupancyGrid(corner((int) left, (int) low), cellMm, columns, rows, both);
    }

    private Pose corner(int column, int row) {
        return origin.plus(new Pose(column * cellMm, row * cellMm, 0));
    }

    private byte cell(int column, int row) {
        return column < 0 || row < 0 || column >= width || row >= height ? UNKNOWN : cells[row * width + column];
    }

    private byte cellAt(Pose place) {
        Pose seen = place.seenFrom(origin);
        return cell((int) Math.floor(seen.xMm() / cellMm), (int) Math.floor(seen.yMm() / cellMm));
    }

    private static byte added(byte one, byte other) {
        if (one == UNKNOWN || other == UNKNOWN) {
            return one == UNKNOWN ? other : one;
        }
        return (byte) Math.max(-Byte.MAX_VALUE, Math.min(Byte.MAX_VALUE, one + other));
    }

    /** Returns the place of the lower left corner, and the direction of the columns, in the frame of the map. */
    public Pose origin() {
        return origin;
    }

    /** Returns the size of a cell, mm. */
    public double cellMm() {
        return cellMm;
    }

    /** Returns the number of columns. */
    public int width() {
        return width;
    }

    /** Returns the number of rows. */
    public int height() {
        return height;
    }

    /**
     * Returns the probability that a cell is occupied.
     *
     * @return 0 to 1; not a number if nothing is known or the cell is outside
     */
    public double probability(int column, int row) {
        return column < 0 || row < 0 || column >= width || row >= height
                ? Double.NaN
                : PROBABILITY[cells[row * width + column] & 0xFF];
    }

    /** Returns what is known of a cell, by {@link #OCCUPIED} and {@link #FREE}; a cell outside is unknown. */
    public State state(int column, int row) {
        double probability = probability(column, row);
        if (probability >= OCCUPIED) {
            return State.OCCUPIED;
        }
        return probability < FREE ? State.FREE : State.UNKNOWN;
    }

    /**
     * Returns what is known of a place.
     *
     * @param xMm in the frame of the map
     * @param yMm in the frame of the map
     * @return the state of the cell there
     */
    public State stateAt(double xMm, double yMm) {
        Pose seen = new Pose(xMm, yMm, 0).seenFrom(origin);
        return state((int) Math.floor(seen.xMm() / cellMm), (int) Math.floor(seen.yMm() / cellMm));
    }

    /**
     * Returns the centre of a cell.
     *
     * @return in the frame of the map, with the heading of the columns
     */
    public Pose centre(int column, int row) {
        return origin.plus(new Pose((column + 0.5) * cellMm, (row + 0.5) * cellMm, 0));
    }

    /** Returns the number of cells of a state. */
    public long count(State state) {
        long count = 0;
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                if (state(column, row) == state) {
                    count++;
                }
            }
        }
        return count;
    }
}
