package majic.pioneer.arcos;

import java.util.ArrayList;
import java.util.List;

/**
 * The report of batteries with electronics of their own (ARCOS sheet 11.3); a plain Pioneer 3 has none. Immutable.
 *
 * @param cells in the robot's order
 */
public record Batteries(List<Cell> cells) implements Report {
    /**
     * One battery. What did not come is zero. Immutable.
     *
     * @param flags1 bits of the battery's own
     * @param flags2 bits of the battery's own
     * @param flags3 bits of the battery's own
     * @param relativePercent relative charge, as the battery computes it
     * @param absolutePercent absolute charge, as the battery computes it
     */
    public record Cell(int flags1, int flags2, int flags3, int relativePercent, int absolutePercent) {}

    /** Keeps a copy. */
    public Batteries {
        cells = List.copyOf(cells);
    }

    static Batteries read(FieldReader fields) {
        int count = fields.ubyte();
        int bytesEach = fields.ubyte();
        List<Cell> cells = new ArrayList<>();
        while (cells.size() < count && bytesEach > 0 && fields.remaining() >= bytesEach) {
            FieldReader cell = fields.part(bytesEach);
            cells.add(new Cell(cell.ubyte(), cell.ubyte(), cell.ubyte(), cell.ubyte(), cell.ubyte()));
        }
        return new Batteries(cells);
    }
}
