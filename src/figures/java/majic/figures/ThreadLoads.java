package majic.figures;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/** The processor time of this process, and of its threads, as a share of one core. */
final class ThreadLoads {
    private static final int SETTLING_S = 30;
    private static final int MEASURED_S = 30;
    private static final double LEAST_PERCENT = 0.1;

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final OperatingSystemMXBean SYSTEM =
            (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();

    private final long nanos = System.nanoTime();
    private final long processNanos = SYSTEM.getProcessCpuTime();
    private final Map<String, Long> threadNanos = threads();

    /** Measures a program with nothing to do, once its robots are connected and its code is compiled. */
    static List<String> idle() throws InterruptedException {
        Thread.sleep(SETTLING_S * 1000);
        ThreadLoads before = new ThreadLoads();
        Thread.sleep(MEASURED_S * 1000);
        return new ThreadLoads().since(before);
    }

    private static Map<String, Long> threads() {
        Map<String, Long> nanos = new HashMap<>();
        for (ThreadInfo thread : THREADS.getThreadInfo(THREADS.getAllThreadIds())) {
            if (thread != null) {
                nanos.merge(thread.getThreadName(), THREADS.getThreadCpuTime(thread.getThreadId()), Long::sum);
            }
        }
        return nanos;
    }

    /**
     * Lists the kinds of threads, the busiest first, in one line: threads whose names differ in numbers and addresses
     * are one kind.
     */
    String byKindSince(ThreadLoads before) {
        Map<String, Double> kinds = new HashMap<>();
        threadNanos.forEach((name, spent) -> kinds.merge(
                name.replaceAll("[\\d.:/]+", "#"),
                100.0 * (spent - before.threadNanos.getOrDefault(name, 0L)) / (nanos - before.nanos),
                Double::sum));
        return kinds.entrySet().stream()
                .filter(kind -> kind.getValue() >= LEAST_PERCENT)
                .sorted(Map.Entry.comparingByValue(Comparator.reverseOrder()))
                .map(kind -> String.format(Locale.ROOT, "%s %.1f %%", kind.getKey(), kind.getValue()))
                .collect(Collectors.joining(", "));
    }

    /** Lists the process and each thread, the busiest first. */
    private List<String> since(ThreadLoads before) {
        double passed = nanos - before.nanos;
        List<Map.Entry<Double, String>> loads = new ArrayList<>();
        threadNanos.forEach((name, spent) ->
                loads.add(Map.entry(100 * (spent - before.threadNanos.getOrDefault(name, 0L)) / passed, name)));
        loads.sort(Map.Entry.comparingByKey(Comparator.reverseOrder()));
        List<String> lines = new ArrayList<>();
        lines.add(line(100 * (processNanos - before.processNanos) / passed, "all threads"));
        loads.stream()
                .filter(load -> load.getKey() >= LEAST_PERCENT)
                .forEach(load -> lines.add(line(load.getKey(), load.getValue())));
        return lines;
    }

    private static String line(double percent, String name) {
        return String.format(Locale.ROOT, "%5.1f %% %s", percent, name);
    }
}
