package majic.gui.plot;

import majic.gui.plot.data.PlotSource;
import majic.gui.plot.data.Quantity;
import majic.gui.plot.data.Samples;

/**
 * A curve of a plot. Immutable except for its samples.
 *
 * @param quantity what it shows
 * @param style how it is drawn
 * @param samples its readings
 * @param feed adds readings to the samples until it is closed
 */
record Curve(Quantity quantity, CurveStyle style, Samples samples, PlotSource.Feed feed) {}
