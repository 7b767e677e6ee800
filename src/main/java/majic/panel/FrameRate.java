package majic.panel;

import java.util.ArrayDeque;
import java.util.Deque;

/** Counts pictures per second over the last two seconds. Used by one thread. */
public final class FrameRate {
    private static final double WINDOW_S = 2;

    private final Deque<Long> arrivals = new ArrayDeque<>();

    /** Creates a count without pictures. */
    public FrameRate() {}

    /**
     * Records a picture.
     *
     * @param nanos time of its arrival, not before the last one
     * @return pictures per second; 0 after the first
     */
    public double arrived(long nanos) {
        arrivals.addLast(nanos);
        while ((nanos - arrivals.getFirst()) / 1e9 > WINDOW_S) {
            arrivals.removeFirst();
        }
        double seconds = (nanos - arrivals.getFirst()) / 1e9;
        return seconds > 0 ? (arrivals.size() - 1) / seconds : 0;
    }
}
