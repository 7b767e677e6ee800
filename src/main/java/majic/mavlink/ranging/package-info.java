/** The distances that the range finders of a vehicle report: sensors for maps, gaps to its hull. */
@NullMarked
package majic.mavlink.ranging;

import org.jspecify.annotations.NullMarked;
