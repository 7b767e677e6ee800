/**
 * The replay of a recording in a window of its own: the same map and the same panels, fed from the file. No robot can
 * be reached from here.
 */
@NullMarked
package majic.gui.replay;

import org.jspecify.annotations.NullMarked;
