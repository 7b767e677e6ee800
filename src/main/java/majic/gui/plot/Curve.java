package majic.gui.plot;

import majic.bot.Value;
import majic.gui.plot.data.PlotSource;
import majic.gui.plot.data.Quantity;
import majic.gui.plot.data.Samples;
import majic.panel.ReadingText;
import majic.panel.ReadingsPanel;

/**
 * A curve of a plot. Immutable except for its samples.
 *
 * @param quantity what it shows
 * @param robotName the name that the robot had when the curve was added; empty for none
 * @param style how it is drawn
 * @param samples its readings
 * @param feed adds readings to the samples until it is closed
 */
record Curve(Quantity quantity, String robotName, CurveStyle style, Samples samples, PlotSource.Feed feed) {
    /** Returns robot and parameter, for instance {@code 1 Rex sonar[3]}. */
    String name() {
        String robot = robotName.isEmpty() ? "" : robotName + " ";
        return quantity.robot() + " " + robot + quantity.name();
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
