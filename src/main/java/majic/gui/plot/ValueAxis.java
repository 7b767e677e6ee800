package majic.gui.plot;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.DoubleStream;
import majic.bot.Unit;
import majic.gui.plot.data.Points;
import majic.gui.plot.data.Quantity;
import majic.gui.plot.data.Span;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * An axis for all curves of one unit; switches have one of their own. Immutable.
 *
 * @param unit the unit
 * @param switched whether it is the axis of the switches
 * @param range the values shown
 */
record ValueAxis(Unit unit, boolean switched, Span range) {
    private static final Span OF_SWITCHES = new Span(-0.1, 1.1);
    private static final Span WITHOUT_READINGS = new Span(0, 1);

    boolean isOf(Quantity quantity) {
        return quantity.unit() == unit && quantity.switched() == switched;
    }

    /** Returns the unit; degrees as a word, because a sign alone looks like a part of the number beside it. */
    String title() {
        Texts texts = Texts.of(ValueAxis.class);
        if (switched) {
            return texts.get("axis.switches");
        }
        return unit == Unit.DEG ? texts.get("axis.degrees") : Quantity.sign(unit);
    }

    /** Returns the axes of curves, in the order of the curves. */
    static List<ValueAxis> of(Map<Curve, Points> shown, PlotModel.@Nullable Zoom zoom) {
        List<ValueAxis> fixed = zoom == null ? List.of() : zoom.axes();
        List<ValueAxis> axes = new ArrayList<>();
        for (Curve curve : shown.keySet()) {
            Quantity quantity = curve.quantity();
            if (find(axes, quantity).isEmpty()) {
                axes.add(find(fixed, quantity).orElseGet(() -> fitting(quantity, shown)));
            }
        }
        return axes;
    }

    /** Returns the axis of a quantity. */
    static Optional<ValueAxis> find(List<ValueAxis> axes, Quantity quantity) {
        return axes.stream().filter(axis -> axis.isOf(quantity)).findFirst();
    }

    ValueAxis with(Span newRange) {
        return new ValueAxis(unit, switched, newRange);
    }

    private static ValueAxis fitting(Quantity quantity, Map<Curve, Points> shown) {
        Span range = quantity.switched() ? OF_SWITCHES : range(quantity, shown);
        return new ValueAxis(quantity.unit(), quantity.switched(), range);
    }

    private static Span range(Quantity like, Map<Curve, Points> shown) {
        DoubleSummaryStatistics values = shown.entrySet().stream()
                .filter(entry -> entry.getKey().quantity().unit() == like.unit())
                .filter(entry -> !entry.getKey().quantity().switched())
                .flatMapToDouble(entry -> numbers(entry.getValue()))
                .summaryStatistics();
        return values.getCount() == 0 ? WITHOUT_READINGS : Span.ofAxis(values.getMin(), values.getMax());
    }

    private static DoubleStream numbers(Points points) {
        return Arrays.stream(points.values()).filter(value -> !Double.isNaN(value));
    }
}
