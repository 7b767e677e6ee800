/**
 * Localisation: finds robots on a map, by particles if they have range sensors, else by odometry from a known place.
 */
@NullMarked
package majic.nav.localisation;

import org.jspecify.annotations.NullMarked;
