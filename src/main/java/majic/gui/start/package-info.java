/** What the window shows while there is no robot, the team of the last session, and the tour. */
@NullMarked
package majic.gui.start;

import org.jspecify.annotations.NullMarked;
