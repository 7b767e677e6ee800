/** Makes a behaviour's file from classes, a source or a jar. */
@NullMarked
package majic.act.make;

import org.jspecify.annotations.NullMarked;
