/** The zoomable map of robots' panels and of the window: a floor with a grid, the robots' trails, detected points. */
@NullMarked
package majic.panel.map;

import org.jspecify.annotations.NullMarked;
