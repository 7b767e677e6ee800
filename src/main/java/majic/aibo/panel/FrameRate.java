package majic.aibo.panel;

import java.util.ArrayDeque;
import java.util.Deque;

/** How many pictures a second came of late. Used by one thread. */
final class FrameRate {
    private static final double WINDOW_S = 2;

    private final Deque<Long> arrivals = new ArrayDeque<>();

    /** Takes note of a picture; gives the pictures a second over the last two, 0 after the first. */
    double arrived(long nanos) {
        arrivals.addLast(nanos);
        while ((nanos - arrivals.getFirst()) / 1e9 > WINDOW_S) {
            arrivals.removeFirst();
        }
        double seconds = (nanos - arrivals.getFirst()) / 1e9;
        return seconds > 0 ? (arrivals.size() - 1) / seconds : 0;
    }
}
