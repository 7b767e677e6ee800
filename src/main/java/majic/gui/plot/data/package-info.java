/** The readings that plots show: of running robots, of the past since they were connected, and of recordings. */
@NullMarked
package majic.gui.plot.data;

import org.jspecify.annotations.NullMarked;
