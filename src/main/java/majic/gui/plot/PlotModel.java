package majic.gui.plot;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import majic.gui.plot.data.Computation;
import majic.gui.plot.data.CurvePoints;
import majic.gui.plot.data.PlotSource;
import majic.gui.plot.data.Quantity;
import majic.gui.plot.data.Samples;
import majic.gui.plot.data.Span;
import org.jspecify.annotations.Nullable;

/**
 * The state of one plot: its curves and the part of them that is shown. Must be used on the event dispatch thread,
 * except for the points of the curves.
 */
final class PlotModel {
    static final int MOST_CURVES = 24;

    /** Shorter spans cannot be distinguished: robots report at most some hundred times a second. */
    private static final double SHORTEST_S = 0.05;

    private final PlotSource source;
    private final List<Curve> curves = new ArrayList<>();
    private final List<Curve> removed = new ArrayList<>();
    private final List<Runnable> listeners = new ArrayList<>();
    private TimeLength length = TimeLength.MINUTE;
    private @Nullable Double pausedAt;
    private @Nullable Zoom zoom;

    /**
     * A magnified part.
     *
     * @param time the time shown
     * @param axes the axes with a fixed range; the others fit the readings
     */
    record Zoom(Span time, List<ValueAxis> axes) {}

    PlotModel(PlotSource source) {
        this.source = source;
    }

    PlotSource source() {
        return source;
    }

    /** Adds a listener that runs after every change except new readings. */
    void addListener(Runnable listener) {
        listeners.add(listener);
    }

    private void changed() {
        listeners.forEach(Runnable::run);
    }

    List<Curve> curves() {
        return List.copyOf(curves);
    }

    /** Adds curves of the quantities that have none yet, up to {@value #MOST_CURVES} curves in all. */
    void add(List<Quantity> quantities) {
        for (Quantity quantity : quantities) {
            if (curves.size() < MOST_CURVES && !hasCurve(quantity)) {
                Samples samples = new Samples();
                curves.add(new Curve(
                        quantity,
                        source.nameOf(quantity.robot()),
                        freeStyle(),
                        samples,
                        source.feed(quantity, samples)));
            }
        }
        changed();
    }

    /**
     * Returns whether its curves, without the computed ones, are those of some quantities, up to the maximum number.
     */
    boolean shows(List<Quantity> quantities) {
        return curves.stream()
                .filter(curve -> !curve.isComputed())
                .map(Curve::quantity)
                .toList()
                .equals(quantities.stream().distinct().limit(MOST_CURVES).toList());
    }

    boolean hasCurve(Quantity quantity) {
        return curves.stream().anyMatch(curve -> curve.quantity().equals(quantity));
    }

    private CurveStyle freeStyle() {
        return IntStream.range(0, MOST_CURVES)
                .mapToObj(CurveStyle::new)
                .filter(style ->
                        curves.stream().noneMatch(curve -> curve.style().equals(style)))
                .findFirst()
                .orElseThrow();
    }

    /** Adds a curve that is computed from others, unless there is one. */
    void add(Computation computation) {
        if (curves.size() < MOST_CURVES && !hasCurve(computation.quantity())) {
            curves.add(new Curve(computation.quantity(), "", freeStyle(), computation, () -> {}));
        }
        changed();
    }

    /** Removes a curve; one from which others are computed still gets readings until those are removed. */
    void remove(Curve curve) {
        if (curves.remove(curve)) {
            removed.add(curve);
            removed.removeIf(this::closeUnlessNeeded);
            changed();
        }
    }

    private boolean closeUnlessNeeded(Curve curve) {
        boolean needed = curves.stream().anyMatch(other -> isComputedFrom(other.points(), curve.points()));
        if (!needed) {
            curve.feed().close();
        }
        return !needed;
    }

    private static boolean isComputedFrom(CurvePoints points, CurvePoints operand) {
        return points instanceof Computation computation
                && computation.operands().stream()
                        .anyMatch(direct -> direct == operand || isComputedFrom(direct, operand));
    }

    /** Ends the feeds of all curves. */
    void close() {
        Stream.concat(curves.stream(), removed.stream())
                .forEach(curve -> curve.feed().close());
    }

    TimeLength length() {
        return length;
    }

    /** Shows the newest readings of this length of time; ends a zoom. */
    void show(TimeLength newLength) {
        length = newLength;
        zoom = null;
        changed();
    }

    boolean isPaused() {
        return pausedAt != null;
    }

    /** Holds the picture or lets it follow the time again; readings are collected all the time. */
    void pause(boolean paused) {
        pausedAt = paused ? Double.valueOf(source.now()) : null;
        changed();
    }

    boolean isZoomed() {
        return zoom != null;
    }

    @Nullable
    Zoom zoom() {
        return zoom;
    }

    /** Shows a fixed part; null shows the newest readings again. */
    void zoom(@Nullable Zoom part) {
        if (part == null || part.time().length() >= SHORTEST_S) {
            zoom = part;
            changed();
        }
    }

    /** Returns the time shown now. */
    Span time() {
        Zoom part = zoom;
        if (part != null) {
            return part.time();
        }
        Double paused = pausedAt;
        double end = paused == null ? source.now() : paused;
        return new Span(length == TimeLength.ALL ? start(end) : end - length.seconds(), end);
    }

    /** Returns the time of the first reading, at least one second before the end. */
    private double start(double end) {
        return curves.stream()
                .mapToDouble(curve -> curve.points().start())
                .filter(start -> !Double.isNaN(start))
                .reduce(end - 1, Math::min);
    }
}
