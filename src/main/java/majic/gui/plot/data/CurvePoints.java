package majic.gui.plot.data;

/** The points of a curve, in the order of time. Thread-safe. */
public interface CurvePoints {
    /** Returns the last value at a time or before it; NaN if there is none. */
    double at(double seconds);

    /** Returns the time of the oldest point; NaN if there is none. */
    double start();

    /** Returns the points within a span of time, and the ones next to it, so that a curve reaches the edges. */
    Points around(Span span);

    /** Returns the points within a span of time, both ends included. */
    Points within(Span span);
}
