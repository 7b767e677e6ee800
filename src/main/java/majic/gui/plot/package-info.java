/**
 * Live curves of what robots report, in windows of their own: {@link majic.gui.plot.Plots} opens them, and the library
 * XChart paints the charts off the event dispatch thread.
 */
@NullMarked
package majic.gui.plot;

import org.jspecify.annotations.NullMarked;
