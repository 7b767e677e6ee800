package majic.figures;

import java.util.List;
import java.util.Optional;

/** The processor time of other programs from one moment on. */
final class ProcessTimes {
    private final List<ProcessHandle> processes;
    private final long beganNanos = System.nanoTime();
    private final long usedBefore;

    private ProcessTimes(List<ProcessHandle> processes) {
        this.processes = processes;
        this.usedBefore = usedNanos();
    }

    /** Begins now, with the programs of some process numbers. */
    static ProcessTimes of(List<Long> pids) {
        return new ProcessTimes(
                pids.stream().map(ProcessHandle::of).flatMap(Optional::stream).toList());
    }

    private long usedNanos() {
        return processes.stream()
                .mapToLong(one -> one.info().totalCpuDuration().orElseThrow().toNanos())
                .sum();
    }

    /** Returns what they have used since, percent of one core. */
    double percent() {
        return 100.0 * (usedNanos() - usedBefore) / (System.nanoTime() - beganNanos);
    }
}
