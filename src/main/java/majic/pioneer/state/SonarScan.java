package majic.pioneer.state;

import java.util.Arrays;
import majic.pioneer.arcos.SonarReadings;

/** The last range of every disc and when it came. Immutable. */
public final class SonarScan {
    /** As many discs as the protocol can number. */
    static final int DISCS = 32;

    /** The range that a disc reports without an echo, mm. */
    public static final int NOTHING_MM = 5000;

    static final SonarScan EMPTY = new SonarScan(new int[DISCS], new long[DISCS]);

    private final int[] rangesMm;
    private final long[] atNanos;

    private SonarScan(int[] rangesMm, long[] atNanos) {
        this.rangesMm = rangesMm;
        this.atNanos = atNanos;
    }

    /** This scan with the new readings in it; readings of discs beyond the last one are dropped. */
    SonarScan with(SonarReadings readings, double mmPerCount, long nanos) {
        if (readings.count() == 0) {
            return this;
        }
        int[] ranges = Arrays.copyOf(rangesMm, DISCS);
        long[] times = Arrays.copyOf(atNanos, DISCS);
        for (int index = 0; index < readings.count(); index++) {
            int disc = readings.disc(index);
            if (disc < DISCS) {
                ranges[disc] = (int) Math.round(readings.range(index) * mmPerCount);
                times[disc] = nanos == 0 ? 1 : nanos;
            }
        }
        return new SonarScan(ranges, times);
    }

    /** This scan without the readings of some discs. */
    SonarScan without(int firstDisc, int discs) {
        long[] times = Arrays.copyOf(atNanos, DISCS);
        Arrays.fill(times, firstDisc, firstDisc + discs, 0);
        return new SonarScan(rangesMm, times);
    }

    public boolean hasReading(int disc) {
        return atNanos[disc] != 0;
    }

    /** mm from the disc's surface; {@link #NOTHING_MM} or more without an echo. */
    public int rangeMm(int disc) {
        return rangesMm[disc];
    }

    /** When the disc last fired, on the driver's clock. */
    public long atNanos(int disc) {
        return atNanos[disc];
    }
}
