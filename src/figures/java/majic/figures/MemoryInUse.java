package majic.figures;

import java.lang.management.ManagementFactory;
import java.lang.management.MemoryMXBean;
import java.lang.management.MemoryType;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.swing.JFrame;

/** The memory of a program that runs for an hour of its lab, at 30 times real time. */
final class MemoryInUse {
    private static final int SETTLING_S = 20;
    private static final int TEN_MINUTES_S = 20;

    private MemoryInUse() {}

    static List<String> overAnHour(JFrame frame) throws InterruptedException {
        MemoryMXBean memory = ManagementFactory.getMemoryMXBean();
        Thread.sleep(SETTLING_S * 1000);
        List<String> lines = new ArrayList<>();
        for (int minutes = 0; minutes <= 60; minutes += 10) {
            memory.gc();
            double heap = afterCollection() / 1e6;
            double rest = memory.getNonHeapMemoryUsage().getUsed() / 1e6;
            lines.add(String.format(Locale.ROOT, "after %2d min heap %5.1f MB, other %5.1f MB", minutes, heap, rest));
            Thread.sleep(TEN_MINUTES_S * 1000);
        }
        return lines;
    }

    /** Returns what the last collection left, bytes; until the heap is read, the lab may have allocated much more. */
    private static long afterCollection() {
        return ManagementFactory.getMemoryPoolMXBeans().stream()
                .filter(pool -> pool.getType() == MemoryType.HEAP)
                .mapToLong(pool -> pool.getCollectionUsage().getUsed())
                .sum();
    }
}
