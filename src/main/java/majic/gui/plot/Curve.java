package majic.gui.plot;

import java.util.List;
import majic.bot.Value;
import majic.gui.plot.data.Computation;
import majic.gui.plot.data.Computation.Operation;
import majic.gui.plot.data.CurvePoints;
import majic.gui.plot.data.PlotSource;
import majic.gui.plot.data.Quantity;
import majic.panel.ReadingText;
import majic.panel.ReadingsPanel;

/**
 * A curve of a plot. Immutable except for its points.
 *
 * @param quantity what it shows
 * @param robotName the name that the robot had when the curve was added; empty for none
 * @param style how it is drawn
 * @param points its points
 * @param feed adds readings until it is closed
 */
record Curve(Quantity quantity, String robotName, CurveStyle style, CurvePoints points, PlotSource.Feed feed) {
    /**
     * Returns the computation of a curve from others.
     *
     * @param operands one curve, or two for an operation that needs two
     * @param number the number that the operation needs, 0 for none
     */
    static Computation computed(Operation operation, List<Curve> operands, double number) {
        return new Computation(
                operation,
                operands.stream().map(curve -> curve.nameIn(operation)).toList(),
                operands.stream().map(curve -> curve.quantity().unit()).toList(),
                operands.stream().map(Curve::points).toList(),
                number);
    }

    private String nameIn(Operation operation) {
        return isComputed() && operation != Operation.DERIVATIVE ? "(" + name() + ")" : name();
    }

    /** Returns whether it is computed from others. */
    boolean isComputed() {
        return points instanceof Computation;
    }

    /** Returns robot and parameter, for instance {@code 1 Rex sonar[3]}. */
    String name() {
        return robotName.isEmpty() ? quantity.title() : quantity.robot() + " " + robotName + " " + quantity.name();
    }

    /** Returns robot, parameter and unit, for instance {@code 1 Rex sonar[3] (mm)}. */
    String label() {
        return name() + quantity.unitText();
    }

    /** Formats a number of a quantity with its unit; a dash for NaN. */
    static String text(Quantity quantity, double number) {
        if (Double.isNaN(number)) {
            return ReadingsPanel.NONE;
        }
        return ReadingText.of(quantity.switched() ? Value.onOff(number > 0) : Value.of(number, quantity.unit()));
    }
}
