/** The parameters and extra commands of a Pioneer, grouped by theme. */
@NullMarked
package majic.pioneer.parameters;

import org.jspecify.annotations.NullMarked;
