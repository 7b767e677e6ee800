package majic.gui.plot;

import majic.gui.plot.data.PlotSource;
import majic.gui.plot.data.Quantity;
import majic.gui.plot.data.Samples;

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
}
