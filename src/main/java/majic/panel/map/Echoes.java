package majic.panel.map;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Places where a robot met something with its sensors, in bounded memory: one for each square of {@value #CELL_MM} mm, the
 * newest; the oldest go first. Thread-safe; nobody waits for it.
 */
public final class Echoes {
    private static final int CAPACITY = 3000;
    private static final double CELL_MM = 40;
    private static final int ROW = 1 << 20;

    private final Map<Long, Echo> bySquare = new LinkedHashMap<>();
    private List<Echo> copy = List.of();
    private boolean changed;

    /**
     * Something that was met.
     *
     * @param xMm on the floor
     * @param yMm on the floor
     * @param atNanos when, on the robot's clock
     */
    public record Echo(double xMm, double yMm, long atNanos) {}

    /**
     * Takes in what was met, in place of what was met in the same square before.
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

    /** Forgets everything. */
    public synchronized void clear() {
        bySquare.clear();
        changed = true;
    }

    /**
     * All there are.
     *
     * @return the oldest first, 3000 at most; does not change
     */
    public synchronized List<Echo> all() {
        if (changed) {
            copy = List.copyOf(bySquare.values());
            changed = false;
        }
        return copy;
    }
}
