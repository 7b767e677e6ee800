/** Counts the classes and calls between a cause and its effect, and the classes that one other file names. */
@NullMarked
package majic.figures.ways;

import org.jspecify.annotations.NullMarked;
