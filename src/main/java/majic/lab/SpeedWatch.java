package majic.lab;

import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/** Detects that a lab stays clearly below its speed, and reports it once. Used by the clock's thread. */
final class SpeedWatch {
    private static final long WINDOW_NANOS = TimeUnit.SECONDS.toNanos(5);
    private static final double ENOUGH = 0.9;

    /** One slow window may be a program that starts, or a pause of the computer. */
    private static final int SLOW_WINDOWS = 2;

    private final double speed;
    private final Consumer<String> report;
    private long beganNanos;
    private long beganLabNanos;
    private int slow;

    /**
     * @param speed how many times as fast as real time the lab should run
     * @param report receives a sentence
     */
    SpeedWatch(double speed, Consumer<String> report) {
        this.speed = speed;
        this.report = report;
    }

    /** Compares lab time and real time, once in a while. */
    void check(long labNanos, long realNanos) {
        long passed = realNanos - beganNanos;
        if (labNanos == 0) {
            begin(labNanos, realNanos);
        } else if (passed >= WINDOW_NANOS) {
            check((labNanos - beganLabNanos) / (double) passed);
            begin(labNanos, realNanos);
        }
    }

    private void begin(long labNanos, long realNanos) {
        beganLabNanos = labNanos;
        beganNanos = realNanos;
    }

    private void check(double reached) {
        if (slow == SLOW_WINDOWS) {
            return;
        }
        slow = reached < ENOUGH * speed ? slow + 1 : 0;
        if (slow == SLOW_WINDOWS) {
            report.accept("this computer is too slow or too busy for the simulated lab: it runs at " + times(reached)
                    + " real time, not at " + times(speed) + "; nothing is left out, it only takes longer");
        }
    }

    private static String times(double speed) {
        String digits = String.format(Locale.ROOT, "%.2f", speed).replaceFirst("\\.?0+$", "");
        return digits + " times";
    }
}
