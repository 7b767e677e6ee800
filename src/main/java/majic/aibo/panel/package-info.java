/** The dog's panel in the window: camera picture, drawing, head sliders and readings. */
@NullMarked
package majic.aibo.panel;

import org.jspecify.annotations.NullMarked;
