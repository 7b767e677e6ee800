package majic.aibo.panel;

import java.util.ArrayDeque;
import java.util.Deque;

/** The number of pictures per second over the last two seconds. Used by one thread. */
final class FrameRate {
    private static final double WINDOW_S = 2;

    private final Deque<Long> arrivals = new ArrayDeque<>();

    /** Records a picture; returns the rate, 0 after the first. */
    double arrived(long nanos) {
        arrivals.addLast(nanos);
        while ((nanos - arrivals.getFirst()) / 1e9 > WINDOW_S) {
            arrivals.removeFirst();
        }
        double seconds = (nanos - arrivals.getFirst()) / 1e9;
        return seconds > 0 ? (arrivals.size() - 1) / seconds : 0;
    }
}
