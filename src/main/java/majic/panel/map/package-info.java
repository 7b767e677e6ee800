/**
 * The zoomable map of robots' panels and of the window: a floor with a grid, the way a robot came, echoes.
 */
@NullMarked
package majic.panel.map;

import org.jspecify.annotations.NullMarked;
