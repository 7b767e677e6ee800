package majic.panel.map;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Holds places where a robot detected something with its sensors, in bounded memory: one for each square of
 * {@value #CELL_MM} mm, the newest; the oldest are removed first. Thread-safe; no call blocks for long.
 */
public final class Echoes {
    private static final int CAPACITY = 3000;
    private static final double CELL_MM = 40;
    private static final int ROW = 1 << 20;

    private final Map<Long, Echo> bySquare = new LinkedHashMap<>();
    private List<Echo> copy = List.of();
    private boolean changed;

    /**
     * A detected point.
     *
     * @param xMm on the floor
     * @param yMm on the floor
     * @param atNanos time of the detection, on the robot's clock
     */
    public record Echo(double xMm, double yMm, long atNanos) {}

    /**
     * Adds a detected point, replacing an earlier one in the same square.
     *
     * @param echo not older than those before
     */
    public synchronized void add(Echo echo) {
        long square = Math.round(echo.xMm() / CELL_MM) * ROW + Math.round(echo.yMm() / CELL_MM);
        bySquare.remove(square);
        bySquare.put(square, echo);
        if (bySquare.size() > CAPACITY) {
            Iterator<Echo> oldest = bySquare.values().iterator();
            oldest.next();
            oldest.remove();
        }
        changed = true;
    }

    /** Removes all points. */
    public synchronized void clear() {
        bySquare.clear();
        changed = true;
    }

    /**
     * Returns all points.
     *
     * @return the oldest first, 3000 at most; unmodifiable
     */
    public synchronized List<Echo> all() {
        if (changed) {
            copy = List.copyOf(bySquare.values());
            changed = false;
        }
        return copy;
    }
}
