package majic.gui.plot.data;

import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import majic.bot.Unit;
import majic.bot.Value;

/**
 * A curve that is computed from others whenever its points are needed. Immutable.
 *
 * @param operation how
 * @param names the names of the curves
 * @param units their units
 * @param operands their points; one, or two for a sum and a difference
 * @param number the factor of a scaled curve, the seconds over which a smoothed one is averaged; otherwise unused
 */
public record Computation(
        Operation operation, List<String> names, List<Unit> units, List<CurvePoints> operands, double number)
        implements CurvePoints {
    /** How long before a time the points are computed of which the last one holds then, seconds. */
    private static final double LOOK_BACK_S = 5;

    /** The shortest time over which a slope is taken, seconds. */
    private static final double LEAST_SLOPE_S = 0.3;

    /** The ways to compute a curve. */
    public enum Operation {
        SUM,
        DIFFERENCE,
        SCALE,
        DERIVATIVE,
        SMOOTHED;

        /** Returns whether it needs a second curve. */
        public boolean hasTwo() {
            return this == SUM || this == DIFFERENCE;
        }

        /** Returns whether it needs a number. */
        public boolean hasNumber() {
            return this == SCALE || this == SMOOTHED;
        }
    }

    /** Keeps copies of the lists. */
    public Computation {
        names = List.copyOf(names);
        units = List.copyOf(units);
        operands = List.copyOf(operands);
    }

    /** Returns what the curve shows: a quantity of no robot, named by its formula. */
    public Quantity quantity() {
        return Quantity.computed(name(), unit());
    }

    private String name() {
        String first = names.get(0);
        return switch (operation) {
            case SUM -> first + " + " + names.get(1);
            case DIFFERENCE -> first + " \u2212 " + names.get(1);
            case SCALE -> Value.plain(number) + " \u00d7 " + first;
            case DERIVATIVE -> "d(" + first + ")/dt";
            case SMOOTHED -> first + " \u2300 " + Value.plain(number) + " s";
        };
    }

    private Unit unit() {
        Unit first = units.get(0);
        return switch (operation) {
            case SUM, DIFFERENCE -> first == units.get(1) ? first : Unit.NONE;
            case SCALE, SMOOTHED -> first;
            case DERIVATIVE ->
                switch (first) {
                    case MM -> Unit.MM_PER_S;
                    case MM_PER_S -> Unit.MM_PER_S2;
                    case DEG -> Unit.DEG_PER_S;
                    case DEG_PER_S -> Unit.DEG_PER_S2;
                    default -> Unit.NONE;
                };
        };
    }

    @Override
    public double start() {
        return operands.stream()
                .mapToDouble(CurvePoints::start)
                .filter(start -> !Double.isNaN(start))
                .min()
                .orElse(Double.NaN);
    }

    @Override
    public double at(double seconds) {
        Points points = points(new Span(seconds - LOOK_BACK_S, seconds));
        int count = countUntil(points, seconds);
        return count == 0 ? Double.NaN : points.values()[count - 1];
    }

    @Override
    public Points around(Span span) {
        Points points = points(span);
        int from = Math.max(0, countUntil(points, span.from()) - 1);
        int to = Math.min(points.size(), countUntil(points, span.to()) + 1);
        return part(points, from, Math.max(from, to));
    }

    @Override
    public Points within(Span span) {
        Points points = points(span);
        int from = countUntil(points, Math.nextDown(span.from()));
        return part(points, from, Math.max(from, countUntil(points, span.to())));
    }

    /** Returns how many points are not later than a time. */
    private static int countUntil(Points points, double seconds) {
        int count = 0;
        while (count < points.size() && points.times()[count] <= seconds) {
            count++;
        }
        return count;
    }

    private static Points part(Points points, int from, int to) {
        return new Points(Arrays.copyOfRange(points.times(), from, to), Arrays.copyOfRange(points.values(), from, to));
    }

    /** Computes the points of a span, and some beside it. */
    private Points points(Span span) {
        double before = operation == Operation.SMOOTHED ? number : 0;
        Span needed = new Span(span.from() - before - LOOK_BACK_S, span.to());
        Points first = operands.get(0).around(needed);
        return switch (operation) {
            case SUM -> combined(first, operands.get(1).around(needed), 1);
            case DIFFERENCE -> combined(first, operands.get(1).around(needed), -1);
            case SCALE ->
                new Points(
                        first.times(),
                        DoubleStream.of(first.values())
                                .map(value -> number * value)
                                .toArray());
            case DERIVATIVE -> derivative(first);
            case SMOOTHED -> smoothed(first);
        };
    }

    /** Adds values at each time at which one of them changes; each holds until its next point. */
    private static Points combined(Points a, Points b, double sign) {
        double[] times = DoubleStream.concat(DoubleStream.of(a.times()), DoubleStream.of(b.times()))
                .sorted()
                .distinct()
                .toArray();
        double[] values = new double[times.length];
        int inA = 0;
        int inB = 0;
        for (int index = 0; index < times.length; index++) {
            inA = next(a, inA, times[index]);
            inB = next(b, inB, times[index]);
            values[index] = inA == 0 || inB == 0 ? Double.NaN : a.values()[inA - 1] + sign * b.values()[inB - 1];
        }
        return new Points(times, values);
    }

    private static int next(Points points, int from, double seconds) {
        int count = from;
        while (count < points.size() && points.times()[count] <= seconds) {
            count++;
        }
        return count;
    }

    /**
     * Returns the slope up to each point, over a time that is long beside the jitter of reports. Between points that
     * are far from each other the slope is constant.
     */
    private static Points derivative(Points of) {
        double[] times = new double[2 * of.size()];
        double[] values = new double[2 * of.size()];
        int count = 0;
        int from = -1;
        for (int index = 1; index < of.size(); index++) {
            double end = of.times()[index];
            while (end - of.times()[from + 1] >= LEAST_SLOPE_S) {
                from++;
            }
            if (from >= 0) {
                double slope = (of.values()[index] - of.values()[from]) / (end - of.times()[from]);
                double begin = of.times()[index - 1] + LEAST_SLOPE_S;
                if (begin < end - LEAST_SLOPE_S) {
                    times[count] = begin;
                    values[count++] = slope;
                }
                times[count] = end;
                values[count++] = slope;
            }
        }
        return new Points(Arrays.copyOf(times, count), Arrays.copyOf(values, count));
    }

    /** Returns at each point the mean of the values of the seconds before it; a gap stays one. */
    private Points smoothed(Points of) {
        double[] values = new double[of.size()];
        int from = 0;
        int counted = 0;
        double sum = 0;
        for (int index = 0; index < of.size(); index++) {
            double value = of.values()[index];
            if (Double.isNaN(value)) {
                from = index + 1;
                counted = 0;
                sum = 0;
                values[index] = Double.NaN;
                continue;
            }
            sum += value;
            counted++;
            while (of.times()[from] < of.times()[index] - number) {
                sum -= of.values()[from++];
                counted--;
            }
            values[index] = sum / counted;
        }
        return new Points(of.times(), values);
    }
}
